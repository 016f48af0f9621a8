// Bolster's side of a benchmark.
#pragma once

#include "PreparedSheet.h"
#include "Relaxation.h"

#include <functional>

namespace bolster::bench {

/// All benchmarks run on so many threads.
inline constexpr int threads = 2;

/// A design set up to be iterated for as long as one likes.
class Rig {
public:
    using MakeGhosts = std::function<Ghosts(const SewnMesh&)>;

    /// Soft targets are those of the design's elements, if any, else those of `standIn`.
    explicit Rig(const SolveInput& input, const MakeGhosts& standIn = {});

    const SewnMesh& mesh() const { return m_sheet.mesh; }
    WorkerPool& pool() { return m_pool; }

    /// From the start that the design has in the program.
    void startCanonically() { m_relaxation->startCanonically(); }
    /// From the flat pattern with the held vertices at their targets, like the peers; one patch only.
    void startFlat();
    /// Returns the largest move, relative to D. Throws when the surface ran away.
    double iterate();

private:
    PreparedSheet m_sheet;
    WorkerPool m_pool{threads};
    std::optional<Relaxation> m_relaxation;
};

} // namespace bolster::bench
