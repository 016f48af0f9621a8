#include "CanonicalSolve.h"

#include "StartPlacement.h"

namespace bolster {

namespace {

// Lifts folded starts to the right side before the cover is released (docs/solver.md, "Start").
constexpr int inflationIterations = 40;
constexpr double inflationPressure = 0.5;

} // namespace

CanonicalSolve::CanonicalSolve(const SewnMesh& mesh, WorkerPool& pool, double tolerance)
    : m_mesh(mesh)
    , m_optimizer(mesh, pool)
    , m_factorTime(m_watch.elapsed())
    , m_convergence(tolerance)
{
    if (!m_optimizer.ok()) {
        fail({QT_TRANSLATE_NOOP("Message",
                                "The equations of the cover could not be solved: a patch is degenerate or its "
                                "numbers are too large."),
              {}});
        return;
    }
    SheetState start = startPlacement(mesh);
    seedFolds(mesh, start);
    m_optimizer.restart(std::move(start));
    m_optimizer.setExtraPressure(inflationPressure);
}

void CanonicalSolve::iterate()
{
    const std::optional<double> move = m_optimizer.iterate();
    if (!move) {
        fail({QT_TRANSLATE_NOOP("Message",
                                "The surface ran away after %1 iterations. Lower the pressure or check the "
                                "sizes of the patches."),
              {std::to_string(m_iterations)}});
        return;
    }
    m_movement = *move;
    ++m_iterations;
    if (m_phase == Phase::Inflating) {
        if (m_iterations < inflationIterations)
            return;
        m_optimizer.setExtraPressure(0);
        m_optimizer.restart(m_optimizer.state());
        m_phase = Phase::Relaxing;
    } else if (m_convergence.add(m_movement)) {
        m_phase = Phase::Converged;
    }
}

void CanonicalSolve::fail(Message reason)
{
    m_phase = Phase::Failed;
    m_reason = std::move(reason);
}

} // namespace bolster
