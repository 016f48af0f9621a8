#include "Convergence.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bolster {

namespace {

constexpr int window = 8; // accelerated moves go up and down within a few iterations
constexpr double slowest = 0.9995;
constexpr int enough = 3; // in a row
// Of the samples the true distance is up to ten times what this estimate says of momentum, and up to three times
// what mixing says of itself: so both end as near to rest.
constexpr double mixedShare = 3.0 / 10;
constexpr int stage = 200; // iterations between two looks for a stall
constexpr int plainIterations = 100;
constexpr double leading = 0.5; // of the path: so far from where it began
constexpr int fitSteps = 10;
constexpr double fitChange = 1e-3;

} // namespace

bool Convergence::add(double move, double left, const Way& way)
{
    m_mixedInARow = mixedShare * left * move < m_tolerance ? m_mixedInARow + 1 : 0;
    if (m_mixedInARow >= enough)
        return true;
    watchForStall(move, way);
    m_moves.push_back(move);
    if (m_moves.size() > 2 * window)
        m_moves.pop_front();
    if (m_moves.size() < 2 * window) {
        m_estimate = std::max(m_estimate, move);
        return false;
    }
    const double older = *std::max_element(m_moves.begin(), m_moves.begin() + window);
    const double newer = *std::max_element(m_moves.begin() + window, m_moves.end());
    if (newer <= 1e-15) {
        m_estimate = newer;
    } else {
        const double rho = std::min(slowest, std::pow(newer / older, 1.0 / window));
        m_estimate = newer / (1 - rho);
    }
    m_inARow = m_estimate < m_tolerance ? m_inARow + 1 : 0;
    return m_inARow >= enough;
}

void Convergence::forget()
{
    m_moves.clear();
    m_inARow = 0;
    m_mixedInARow = 0;
}

bool FitConvergence::add(double misfit)
{
    m_misfits.push_back(misfit);
    if (m_misfits.size() < 2 * fitSteps)
        return false;
    if (m_misfits.size() > 2 * fitSteps)
        m_misfits.pop_front();
    const double older = std::accumulate(m_misfits.begin(), m_misfits.begin() + fitSteps, 0.0);
    const double newer = std::accumulate(m_misfits.begin() + fitSteps, m_misfits.end(), 0.0);
    return newer > 0 && std::abs(newer - older) < fitChange * newer;
}

/// Compares the largest moves of successive stages. Momentum that gathers speed along a way that hardly anything
/// resists is no stall.
void Convergence::watchForStall(double move, const Way& way)
{
    if (m_plainLeft > 0)
        --m_plainLeft;
    m_largestOfStage = std::max(m_largestOfStage, move);
    m_pathOfStage += move;
    if (++m_count % stage != 0)
        return;
    const bool leads = (way ? way() : 0) > leading * m_pathOfStage;
    if (m_count > stage && m_largestOfStage > 0.8 * m_largestBefore && !leads)
        m_plainLeft = plainIterations;
    m_largestBefore = m_largestOfStage;
    m_largestOfStage = 0;
    m_pathOfStage = 0;
}

} // namespace bolster
