// Bolster's side of a benchmark.
#pragma once

#include "MakeGhosts.h"
#include "PreparedSheet.h"
#include "Relaxation.h"

namespace bolster::bench {

/// All benchmarks run on so many threads.
inline constexpr int threads = 2;

/// A design set up to be iterated for as long as one likes.
class Rig {
public:
    explicit Rig(const SolveInput& input);

    const SewnMesh& mesh() const { return m_sheet.mesh; }
    WorkerPool& pool() { return m_pool; }

    /// From the start that the design has in the program.
    void startCanonically() { m_relaxation->startCanonically(); }
    /// From the flat pattern with the held vertices at their targets, like the peers; one patch only.
    void startFlat();
    /// With a scan: iterates until the cover is being fitted to it. Else nothing.
    void reachFit();
    /// Returns the largest move, relative to D. A fit that has settled goes on. Throws when the surface ran away.
    double iterate();

private:
    PreparedSheet m_sheet;
    WorkerPool m_pool{threads};
    GhostCache m_ghostCache;
    std::optional<Relaxation> m_relaxation;
};

} // namespace bolster::bench
