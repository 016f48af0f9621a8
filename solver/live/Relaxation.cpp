#include "Relaxation.h"

#include "FoldSeeds.h"
#include "StartPlacement.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bolster {

namespace {

// Relative to D: how near to rest a cover must be before it is fitted.
constexpr double restBeforeFit = 1e-4;
constexpr double lessWhenLost = 10; // a cover must move before it is mixed again

} // namespace

Relaxation::Relaxation(const SewnMesh& mesh, WorkerPool& pool, double tolerance, Ghosts ghosts,
                       const std::stop_token& stop)
    : m_optimizer(mesh, pool, std::move(ghosts), stop)
    , m_tolerance(tolerance)
    , m_convergence(tolerance)
    , m_factorTime(m_watch.elapsed())
{
    checkFactors();
}

void Relaxation::startCanonically()
{
    startFrom(startPlacement(m_optimizer.mesh()), true);
    if (m_phase == Phase::Failed)
        return;
    // Only now, with the fixed and sewn outlines in place, is it known where the cloth is compressed.
    SheetState seeded = m_optimizer.state();
    seedFolds(m_optimizer.mesh(), seeded);
    m_optimizer.restart(std::move(seeded));
}

void Relaxation::startFrom(SheetState state, bool torn)
{
    if (!checkFactors())
        return;
    m_fitting = !torn && hasFits();
    if (!m_optimizer.setFitting(m_fitting))
        factorAgain();
    if (!checkFactors())
        return;
    m_optimizer.restart(std::move(state));
    if (torn)
        m_optimizer.relaxPositions();
    begin();
}

void Relaxation::startNear(SheetState state)
{
    startFrom(std::move(state), false);
    m_mixFrom = {5, 1e-3}; // its folds are there
}

void Relaxation::startStill(SheetState state)
{
    startFrom(std::move(state), false);
    if (m_phase != Phase::Failed)
        m_optimizer.standStill();
}

void Relaxation::retarget(Ghosts ghosts)
{
    replaceGhosts(std::move(ghosts), false);
}

void Relaxation::refactor(Ghosts ghosts)
{
    replaceGhosts(std::move(ghosts), true);
}

void Relaxation::reshape(Ghosts ghosts)
{
    m_optimizer.reshape();
    replaceGhosts(std::move(ghosts), false);
}

void Relaxation::replaceGhosts(Ghosts ghosts, bool refactor)
{
    const bool sameWeights = m_optimizer.replaceGhosts(std::move(ghosts));
    m_fitting = hasFits() && (m_fitting || m_phase == Phase::Converged);
    if (!m_optimizer.setFitting(m_fitting) || !sameWeights || refactor)
        factorAgain();
    if (!checkFactors())
        return;
    m_optimizer.retarget();
    begin();
}

void Relaxation::factorAgain()
{
    m_watch.restart();
    m_optimizer.refactor();
    m_factorTime = m_watch.elapsed();
}

void Relaxation::iterate()
{
    if (m_phase != Phase::Running)
        return;
    if (m_optimizer.setAcceleration(acceleration()))
        m_convergence.forget();
    m_watch.restart();
    const std::optional<double> move = m_optimizer.iterate();
    m_iterateTime += m_watch.elapsed();
    if (!move) {
        m_ranAway = true;
        fail({QT_TRANSLATE_NOOP("Message", "The surface ran away after %1 iterations."),
              {std::to_string(m_iterations)}});
        return;
    }
    m_movement = *move;
    ++m_iterations;
    const bool atRest =
        m_convergence.add(m_movement, m_optimizer.left(), [this] { return m_optimizer.wayFromMark(); });
    if (!m_fitting && hasFits()) {
        if (atRest)
            beginFit();
    } else if (atRest || (m_fitting && m_fitConvergence.add(misfit()))) {
        m_phase = Phase::Converged;
    }
}

SheetOptimizer::Acceleration Relaxation::acceleration()
{
    using enum SheetOptimizer::Acceleration;
    if (m_convergence.stalled()) {
        m_mixing = false;
        return None;
    }
    if (m_mixing && m_optimizer.lost()) {
        m_mixing = false;
        m_mixFrom.movement /= lessWhenLost;
    }
    const bool begins = m_iterations >= m_mixFrom.iterations && m_movement < m_mixFrom.movement;
    m_mixing = m_mayMix && !m_fitting && (m_mixing || begins);
    return m_mixing ? Mixing : Momentum;
}

bool Relaxation::hasFits() const
{
    return std::ranges::any_of(m_optimizer.ghosts(),
                               [](const auto& source) { return source->misfit().has_value(); });
}

double Relaxation::misfit() const
{
    double squares = 0;
    for (const auto& source : m_optimizer.ghosts())
        squares += std::pow(source->misfit().value_or(0), 2);
    return std::sqrt(squares);
}

void Relaxation::beginFit()
{
    m_fitting = true;
    if (!m_optimizer.setFitting(true))
        factorAgain();
    if (!checkFactors())
        return;
    m_optimizer.retarget();
    beginConvergence();
}

bool Relaxation::checkFactors()
{
    if (!m_optimizer.ok())
        fail({QT_TRANSLATE_NOOP("Message",
                                "The equations of the cover could not be solved: a patch is degenerate or its "
                                "numbers are too large."),
              {}});
    return m_optimizer.ok();
}

void Relaxation::begin()
{
    m_phase = Phase::Running;
    m_iterations = 0;
    m_iterateTime = 0;
    m_mixing = false;
    m_mixFrom = {20, 1e-4}; // first it must be decided which folds a cover takes: mixing goes to any shape at rest
    beginConvergence();
}

void Relaxation::beginConvergence()
{
    const bool fitFollows = hasFits() && !m_fitting;
    m_convergence = Convergence(fitFollows ? std::max(m_tolerance, restBeforeFit) : m_tolerance);
    m_fitConvergence = {};
}

void Relaxation::fail(Message reason)
{
    m_phase = Phase::Failed;
    m_reason = std::move(reason);
}

} // namespace bolster
