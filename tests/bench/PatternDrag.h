// A drag in the pattern, as the workbench does it: designs go to the solver's thread, surfaces come back.
#pragma once

#include "Design.h"
#include "SolverThread.h"

#include <semaphore>

namespace bolster::bench {

class PatternDrag {
public:
    /// Waits until the seat has come to rest.
    explicit PatternDrag(Design seat);

    /// Moves the pointer and returns how long the surface for it took, ms. To and fro, up to a warp of 15 %.
    double move();
    enum class Until { NewTriangles, Rest };
    /// Releases the button and returns how long the first surface on the new triangles took, or the one at rest,
    /// ms.
    double release(Until until);

private:
    double request(Design design, bool passing, const std::function<bool(const SolverOutput&)>& answered);

    static constexpr int steps = 12;
    static constexpr double farthest = 0.15;

    Design m_seat;
    int m_moves = 0;
    int m_releases = 0;
    std::uint64_t m_revision = 0;
    std::uint64_t m_topology = 0; // serial of the last surface's
    std::counting_semaphore<> m_woken{0};
    SolverThread m_thread{[this] { m_woken.release(); }}; // last, so that it ends first
};

} // namespace bolster::bench
