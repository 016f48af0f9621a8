// Large designs are dragged on fewer triangles: as many as a step of a gesture has time for.
#include "SolverWorker.h"
#include "StateTransfer.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace bolster {

namespace {

constexpr double overBudget = 1.25;       // times the budget
constexpr double fewestVertices = 20'000; // of a stand-in
constexpr double iterationsOfStep = 5;    // what a step takes, its only iteration, targets and surface together
constexpr int measured = 10;              // iterations, to learn how long one takes

} // namespace

bool SolverWorker::tooLarge(const Sheet& sheet) const
{
    return !sheet.standsIn && !sheet.alone && sheet.vertices() > overBudget * standInVertices();
}

double SolverWorker::standInVertices() const
{
    return std::max(m_stepBudget / m_stepTime, fewestVertices);
}

/// mm, of a sheet that is too large.
double SolverWorker::standInEdge(const Sheet& sheet) const
{
    return sheet.prepared.design.settings().edgeLength * std::sqrt(sheet.vertices() / standInVertices());
}

/// Null when it was given up, or could not be made: it is not needed, only quicker.
std::unique_ptr<SolverWorker::Sheet> SolverWorker::makeStandIn(const SolveInput& input, double edge)
{
    try {
        std::unique_ptr<Sheet> sheet = prepare(withEdgeLength(input, edge), m_standInTriangulations);
        if (!sheet || !factor(*sheet, liveTolerance) || !sheet->relaxation ||
            sheet->relaxation->phase() == Relaxation::Phase::Failed)
            return nullptr;
        sheet->standsIn = true;
        return sheet;
    } catch (const std::exception&) { // no memory for both
        return nullptr;
    }
}

/// For a design whose triangles are others than those of the live sheet. Null when it was given up.
std::unique_ptr<SolverWorker::Sheet> SolverWorker::makeLive(const SolveInput& input)
{
    const double asked = input.design.settings().edgeLength;
    double edge = asked;
    std::unique_ptr<Sheet> sheet;
    if (!m_live && !(sheet = prepare(input, m_triangulations)))
        return nullptr;
    const Sheet& like = m_live ? *m_live : *sheet;
    if (like.standsIn)
        edge = like.prepared.design.settings().edgeLength;
    else if (tooLarge(like))
        edge = standInEdge(like);
    if (edge > asked) {
        std::unique_ptr<Sheet> fewer = makeStandIn(input, edge);
        if (fewer && (!m_live || fewer->prepared.leftOut.size() <= m_live->prepared.leftOut.size()))
            return fewer;
    }
    if (!sheet && !(sheet = prepare(input, m_triangulations)))
        return nullptr;
    return factor(*sheet, liveTolerance) ? std::move(sheet) : nullptr;
}

/// If the live sheet is too large, one with fewer triangles takes its place, where it is. False when that was given
/// up.
bool SolverWorker::standIn()
{
    if (!m_live || !tooLarge(*m_live))
        return true;
    std::unique_ptr<Sheet> next = std::move(m_standIn);
    if (!next || planSolve(m_standInInput, m_liveInput) != SolvePlan::Nothing)
        next = makeStandIn(m_liveInput, standInEdge(*m_live));
    if (m_preparing.stop_requested())
        return false;
    if (!next || next->prepared.mesh.parts.size() != m_live->prepared.mesh.parts.size()) {
        m_live->alone = true;
        return true;
    }
    SheetState state = transferState(m_live->prepared.mesh, m_live->relaxation->state(), next->prepared.mesh);
    if (m_atRest || m_liveEnded)
        next->relaxation->startStill(std::move(state));
    else
        next->relaxation->startFrom(std::move(state), false);
    m_live = std::move(next);
    m_atRest = false;
    return true;
}

/// Before a gesture needs it. False when there is nothing to do.
bool SolverWorker::prepareStandIn()
{
    if (m_standIn || !m_live || !m_live->relaxation || !tooLarge(*m_live))
        return false;
    m_standIn = makeStandIn(m_liveInput, standInEdge(*m_live));
    m_standInInput = m_liveInput;
    if (!m_standIn && !m_preparing.stop_requested())
        m_live->alone = true;
    return true;
}

void SolverWorker::learnStepTime()
{
    const Relaxation& relaxation = *m_live->relaxation;
    if (relaxation.iterations() == measured)
        m_stepTime = iterationsOfStep * relaxation.iterateTime() / (measured * m_live->vertices());
}

} // namespace bolster
