// An optimizer that runs until it has converged, one iteration at a time.
#pragma once

#include "Convergence.h"
#include "SheetOptimizer.h"
#include "Stopwatch.h"

namespace bolster {

/// Callers can stop between iterations, show progress, or go on after a change. It begins with momentum and goes on
/// by mixing when it is near to rest. When the moves stop shrinking it iterates without acceleration until they do
/// again: an accelerated iteration can circle around a kink of the energy. Ghosts that are fits wait until the
/// cover has come to rest without them.
class Relaxation {
public:
    enum class Phase { Running, Converged, Failed };

    /// Factors; failed when that did not succeed, or was stopped. `tolerance` is relative to D. Mesh and pool must
    /// outlive it.
    Relaxation(const SewnMesh& mesh, WorkerPool& pool, double tolerance, Ghosts ghosts = {},
               const std::stop_token& stop = {});

    /// Gives back the memory that only iterations need, half of all: there can be none any more.
    void release() { m_optimizer.release(); }
    /// Momentum all the way, to compare with.
    void doNotMix() { m_mayMix = false; }
    /// From the start that depends on the design alone.
    void startCanonically();
    /// From any other state. `torn`: seams or fixations are new to it, so that its frames say more than its
    /// positions.
    void startFrom(SheetState state, bool torn);
    /// From where it came to rest on other triangles.
    void startNear(SheetState state);
    /// The same, to stay there until something changes: what these triangles would make of it otherwise is left
    /// out.
    void startStill(SheetState state);
    /// After updateTargets() or updateMaterials() on the mesh.
    void retarget(Ghosts ghosts = {});
    /// The same when matrices change too.
    void refactor(Ghosts ghosts = {});
    /// After reshape() of the mesh.
    void reshape(Ghosts ghosts = {});
    /// As in SheetOptimizer: any of these may have to factor the matrices.
    int factorings() const { return m_optimizer.factorings(); }

    /// One iteration; does nothing unless running.
    void iterate();

    Phase phase() const { return m_phase; }
    int iterations() const { return m_iterations; }              ///< since the last start
    double movement() const { return m_movement; }               ///< of the last iteration, relative to D
    double estimate() const { return m_convergence.estimate(); } ///< distance to the limit, relative to D
    double factorTime() const { return m_factorTime; }           ///< of the last factorisation, ms
    double iterateTime() const { return m_iterateTime; }         ///< since the last start, ms
    const Message& reason() const { return m_reason; }           ///< when failed; see explainFailure(), too
    bool ranAway() const { return m_ranAway; }                   ///< failed while iterating
    const SewnMesh& mesh() const { return m_optimizer.mesh(); }
    SheetState state() const { return m_optimizer.state(); }
    const Ghosts& ghosts() const { return m_optimizer.ghosts(); }
    void reportGhosts(SolveReport& report) const { m_optimizer.report(report); }

private:
    bool checkFactors();
    void factorAgain();
    void begin();
    bool hasFits() const;
    double misfit() const;
    SheetOptimizer::Acceleration acceleration();
    void beginFit();
    void replaceGhosts(Ghosts ghosts, bool refactor);
    void beginConvergence();
    void fail(Message reason);

    Stopwatch m_watch; // before the optimizer, which factors
    SheetOptimizer m_optimizer;
    double m_tolerance;
    Convergence m_convergence;
    FitConvergence m_fitConvergence;
    bool m_fitting = false; // fits act
    /// When mixing begins.
    struct MixFrom {
        int iterations = 0;
        double movement = 0; ///< at most
    };

    bool m_mayMix = true;
    bool m_mixing = false;
    MixFrom m_mixFrom;
    Phase m_phase = Phase::Running;
    int m_iterations = 0;
    double m_movement = 0;
    double m_factorTime = 0;
    double m_iterateTime = 0;
    Message m_reason;
    bool m_ranAway = false;
};

} // namespace bolster
