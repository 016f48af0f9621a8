// The solve whose result depends on the design alone: start, inflation, release, iteration to the tolerance.
#pragma once

#include "Convergence.h"
#include "SheetOptimizer.h"
#include "Stopwatch.h"

namespace bolster {

/// Runs one iteration at a time, so that callers can stop, show progress, or do it in the background.
class CanonicalSolve {
public:
    enum class Phase { Inflating, Relaxing, Converged, Failed };

    /// Factors. `tolerance` is relative to D. The mesh and the pool must outlive it.
    CanonicalSolve(const SewnMesh& mesh, WorkerPool& pool, double tolerance);

    Phase phase() const { return m_phase; }
    bool running() const { return m_phase == Phase::Inflating || m_phase == Phase::Relaxing; }
    void iterate();

    int iterations() const { return m_iterations; }
    double movement() const { return m_movement; } ///< of the last iteration, relative to D
    double estimate() const { return m_convergence.estimate(); }
    double factorTime() const { return m_factorTime; } ///< ms
    const Message& reason() const { return m_reason; } ///< when failed
    const SheetState& state() const { return m_optimizer.state(); }

private:
    void fail(Message reason);

    const SewnMesh& m_mesh;
    Stopwatch m_watch; // before the optimizer, whose construction it times
    SheetOptimizer m_optimizer;
    double m_factorTime;
    Convergence m_convergence;
    Phase m_phase = Phase::Inflating;
    int m_iterations = 0;
    double m_movement = 0;
    Message m_reason;
};

} // namespace bolster
