// How the solver thread follows a gesture: from the surface that is shown, with as little new as possible.
#include "DesignCheck.h"
#include "Relief.h"
#include "SheetFollow.h"
#include "SolverWorker.h"
#include "StateTransfer.h"
#include "SurfacePublisher.h"

#include <algorithm>
#include <utility>

namespace bolster {

namespace {

constexpr double publishInterval = 15; // ms: nobody sees more

} // namespace

void SolverWorker::beginLive(Request request)
{
    m_gesture = true;
    if (!m_live && m_shownKept && !continueKept())
        return;                 // given up: what comes next is no gesture
    if (!m_live && m_resting) { // a design that is still being opened
        m_live = std::move(m_resting);
        m_liveInput = m_restingInput;
        m_atRest = false; // what was at rest was a design without anything to solve
    }
    if (m_resting && planSolve(m_restingInput, request.input) != SolvePlan::Nothing)
        m_resting.reset();
    if (!m_resting)
        m_liveEnded = m_restingWaits = false;
    if (!startLive(request.input))
        return; // given up for a newer request, which starts from what there is
    m_liveInput = std::move(request.input);
    m_designRevision = request.revision;
    if (m_atRest) {
        m_restInput = m_liveInput;
        m_status = m_restStatus;
        publish(m_status.state);
    } else if (!m_live) {
        publish(SolverStatus::State::Idle);
    } else if (m_status.iterations == 0) {
        iterateLive();
    } else {
        publish(m_status.state);
    }
}

/// Brings the live sheet to this design. False when that was given up.
bool SolverWorker::startLive(const SolveInput& input)
{
    const SolvePlan plan = m_live
                               ? together(planSolve(m_liveInput, input), std::exchange(m_owed, SolvePlan::Nothing))
                               : SolvePlan::Resew;
    if (plan == SolvePlan::Nothing)
        return true;
    if (plan == SolvePlan::Republish && republishLive(input.design)) {
        m_restKept = false;
        return true;
    }
    const bool light = plan < SolvePlan::Rebuild;
    if (light && plan != SolvePlan::Republish && !standIn()) {
        m_owed = plan;
        return false;
    }
    // Still about the last design: its surface is there, but what follows may take its time.
    const SolverStatus statusBefore = m_status;
    m_status.stage = SolverStatus::Stage::Triangles;
    if (!light && m_status.state != SolverStatus::State::Moving)
        publish(SolverStatus::State::Preparing);
    m_field.reset();
    const bool retargeted = light && plan != SolvePlan::Republish && retargetLive(input, plan);
    if (!retargeted && !rebuildLive(input, plan == SolvePlan::Resew)) {
        m_owed = light ? plan : SolvePlan::Nothing; // it may be half new
        m_status = statusBefore;
        return false;
    }
    m_atRest = m_liveEnded = false;
    m_shownKept.reset();
    m_status.resting = false;
    m_status.sprang.reset();
    m_status.reason = {};
    m_status.iterations = 0;
    m_rateWatch.restart();
    m_rateCount = 0;
    return true;
}

/// Keeps the solution. False when the change asks for more after all.
bool SolverWorker::republishLive(const Design& design)
{
    const Design usable = usablePart(design, checkDesign(design));
    if (!sameElements(usable, m_live->prepared.design))
        return false;
    m_live->prepared.design = usable;
    updateReliefs(m_live->prepared.mesh, usable);
    publishSurface(surfaceOf(*m_live));
    if (m_atRest)
        reportLive();
    return true;
}

/// Keeps triangles, and samples but for their points. False when the change asks for more after all, or when it was
/// given up.
bool SolverWorker::retargetLive(const SolveInput& asked, SolvePlan plan)
{
    PreparedSheet& prepared = m_live->prepared;
    const SolveInput input =
        m_live->standsIn ? withEdgeLength(asked, prepared.design.settings().edgeLength) : asked;
    Problems problems;
    if (!followDesign(prepared, m_live->warp, input, plan, m_pool, problems))
        return false;
    m_live->stale = true;
    Ghosts ghosts = ghostsFor(prepared, problems);
    if (m_preparing.stop_requested())
        return false; // they are not all there
    if (plan == SolvePlan::Warp)
        m_live->relaxation->reshape(std::move(ghosts));
    else if (plan == SolvePlan::Refactor)
        m_live->relaxation->refactor(std::move(ghosts));
    else
        m_live->relaxation->retarget(std::move(ghosts));
    m_status.problems = std::move(problems);
    return true;
}

/// False when it was given up.
bool SolverWorker::rebuildLive(const SolveInput& input, bool torn)
{
    const bool first = !m_live;
    std::unique_ptr<Sheet> next = makeLive(input);
    if (!next)
        return false;
    m_status.problems = next->prepared.errors;
    m_status.problems.insert(m_status.problems.end(), next->prepared.warnings.begin(),
                             next->prepared.warnings.end());
    if (next->prepared.mesh.parts.empty()) {
        m_live.reset();
        publishSurface(makeSurface(next->prepared.mesh, {}, ++m_surfaceRevision));
        return true;
    }
    if (first) {
        next->relaxation->startCanonically();
    } else {
        const Sheet& source = *m_live;
        SheetState state = transferState(source.prepared.mesh, source.relaxation->state(), next->prepared.mesh);
        if (m_lastWhole)
            fillMissing(m_lastWhole->prepared.mesh, m_lastWhole->relaxation->state(), source.prepared.mesh,
                        next->prepared.mesh, state);
        next->relaxation->startFrom(std::move(state), torn);
    }
    const bool losesPatches = !first && !next->prepared.leftOut.empty();
    if (losesPatches && !m_lastWhole)
        m_lastWhole = std::move(m_live);
    else if (!losesPatches)
        m_lastWhole.reset();
    m_live = std::move(next);
    return true;
}

/// One iteration, and a published surface when somebody could see it.
void SolverWorker::iterateLive()
{
    Relaxation& relaxation = *m_live->relaxation;
    relaxation.iterate();
    if (relaxation.phase() == Relaxation::Phase::Failed) {
        failIn(*m_live);
        return;
    }
    learnStepTime();
    ++m_rateCount;
    const bool first = m_status.iterations == 0;
    m_status.iterations = relaxation.iterations();
    m_status.movement = relaxation.movement();
    if (first || m_sincePublished.elapsed() >= publishInterval) {
        m_status.iterationsPerSecond = 1000 * m_rateCount / std::max(1e-3, m_rateWatch.elapsed());
        publishSurface(surfaceOf(*m_live));
        publish(SolverStatus::State::Moving);
    }
}

/// The pointer stands still, and so does the surface: find out what the resting one will be.
void SolverWorker::endLive()
{
    if (m_live->stale && !m_live->standsIn) {
        // The samples catch up with curves that have moved; the surface goes on from where it is.
        if (rebuildLive(m_liveInput, false) && !m_live)
            publish(SolverStatus::State::Idle);
        return;
    }
    m_liveEnded = true;
    publishSurface(surfaceOf(*m_live));
    reportLive();
    publish(SolverStatus::State::Settled);
    if (!m_resting)
        startResting(m_liveInput, false);
}

} // namespace bolster
