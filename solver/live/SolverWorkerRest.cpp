// How the solver thread finds the surface that follows from a design alone, whatever was shown before.
#include "CoarseStart.h"
#include "CoverMove.h"
#include "SolverWorker.h"
#include "StateTransfer.h"
#include "SurfacePublisher.h"

#include <algorithm>
#include <utility>

namespace bolster {

namespace {

constexpr double restingTolerance = 1e-6; // relative to D
constexpr double visibleDistance = 0.5;   // mm: a resting surface this near replaces the live one during a gesture
constexpr double mostBehind = 20;         // mm: the pointer may be as far ahead of the last step when it is let go
constexpr double farFromCoarse = 12;      // mm: several times what covers on few triangles are off
constexpr double springDistance = 5;      // mm: more than anybody takes for lagging behind the pointer
constexpr double wayInterval = 15;        // ms: between surfaces of a cover that nothing is known of yet
constexpr double countInterval = 100;     // ms: between numbers of iterations

/// Whether outlines have gone about there. They have not when the gesture was undone at once: on the triangles of
/// what was before its cover would be torn.
bool ledNear(const Design& led, const Design& design)
{
    bool near = true;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        const auto* there = led.find<Patch>(id);
        const std::vector<Vec2>& points = patch.outline.points();
        near = near && there && there->outline.points().size() == points.size();
        for (std::size_t k = 0; near && k < points.size(); ++k)
            near = (there->outline.points()[k] - points[k]).norm() <= mostBehind;
    });
    return near;
}

} // namespace

void SolverWorker::beginRest(Request request)
{
    const bool afterGesture = std::exchange(m_gesture, false);
    if (m_atRest && restsAlready(request.input)) {
        m_resting.reset();
        m_status = m_restStatus;
        m_designRevision = request.revision;
        publish(m_status.state);
        return;
    }
    if (RestingSurfacePtr kept = m_kept->find(request.input)) {
        m_designRevision = request.revision;
        showKept(std::move(kept), request.input, afterGesture); // then it was cancelled
        return;
    }
    m_status.resting = false;
    m_status.sprang.reset();
    m_status.reason = {};
    if (m_resting && planSolve(m_restingInput, request.input) == SolvePlan::Nothing) {
        m_restingInput = std::move(request.input);
        m_restingWaits = false;
        publish(SolverStatus::State::Moving);
        return;
    }
    m_resting.reset();
    m_status.iterations = 0;
    m_status.stage = SolverStatus::Stage::Triangles;
    publish(SolverStatus::State::Preparing);
    startResting(request.input, afterGesture);
}

/// Whether the surface that is shown is the answer, perhaps with another depth of its fancy seams.
bool SolverWorker::restsAlready(const SolveInput& input)
{
    const SolvePlan plan = planSolve(m_restInput, input);
    if (plan > SolvePlan::Republish)
        return false;
    if (plan == SolvePlan::Republish) {
        if ((!m_live && (!m_shownKept || !continueKept())) || !republishLive(input.design))
            return false;
        m_shownKept.reset();
        m_restKept = false;
    }
    m_restInput = input;
    if (m_live)
        m_liveInput = input;
    if (!m_restKept)
        keepResting();
    return true;
}

void SolverWorker::showKept(RestingSurfacePtr kept, const SolveInput& input, bool atOnce)
{
    const SurfaceMeshPtr before = m_surface;
    m_live.reset();
    m_standIn.reset();
    m_resting.reset();
    m_field.reset();
    auto surface = std::make_shared<SurfaceMesh>(*kept->surface);
    surface->revision = ++m_surfaceRevision;
    publishSurface(std::move(surface));
    if (!atOnce && before)
        if (CoverMove move = moveBetween(*before, *m_surface); move.distance > visibleDistance)
            m_from = std::move(move.from);
    m_report = kept->report;
    m_status.problems = kept->problems;
    m_status.reason = kept->reason;
    m_status.iterations = kept->iterations;
    m_status.sprang.reset();
    m_shownKept = std::move(kept);
    m_restKept = true;
    m_restInput = input;
    beAtRest();
}

/// Makes a sheet of the kept surface that is shown, from which a gesture can go on. False when it was given up.
bool SolverWorker::continueKept()
{
    std::unique_ptr<Sheet> sheet = makeSheet(m_restInput, liveTolerance);
    if (!sheet)
        return false;
    const SheetState& state = m_shownKept->state;
    if (state.positions.cols() == sheet->prepared.mesh.unknownCount() &&
        state.frames.cols() == sheet->prepared.mesh.vertexCount())
        sheet->relaxation->startFrom(state, false);
    else // cannot be
        sheet->relaxation->startCanonically();
    m_live = std::move(sheet);
    m_liveInput = m_restInput;
    m_owed = SolvePlan::Nothing;
    m_shownKept.reset();
    if (m_drawsField)
        publish(m_status.state);
    return true;
}

void SolverWorker::keepResting()
{
    if (m_live)
        m_kept->keep({m_restInput, m_surface, m_live->relaxation->state(), m_report, m_status.problems,
                      m_status.reason, m_status.iterations});
    m_restKept = true;
}

void SolverWorker::startResting(const SolveInput& input, bool afterGesture)
{
    const auto preparesRest = [this](std::optional<SolveInput> what) {
        const std::lock_guard lock(m_requestMutex);
        m_preparesRest = std::move(what);
    };
    m_restingWaits = false;
    preparesRest(input);
    std::unique_ptr<Sheet> sheet;
    try {
        sheet = sheetAtStart(input, afterGesture);
    } catch (...) {
        preparesRest(std::nullopt);
        throw;
    }
    preparesRest(std::nullopt);
    if (!sheet)
        return; // a newer request is there
    m_restingInput = input;
    if (!m_gesture) {
        m_status.problems = sheet->prepared.errors;
        m_status.problems.insert(m_status.problems.end(), sheet->prepared.warnings.begin(),
                                 sheet->prepared.warnings.end());
    }
    if (sheet->relaxation) {
        m_resting = std::move(sheet);
        m_rateWatch.restart();
    } else if (!m_gesture) {
        publishSurface(makeSurface(sheet->prepared.mesh, {}, ++m_surfaceRevision));
        restEmpty();
    }
}

/// Null when it was given up.
std::unique_ptr<SolverWorker::Sheet> SolverWorker::sheetAtStart(const SolveInput& input, bool afterGesture)
{
    std::unique_ptr<Sheet> sheet = prepare(input, m_triangulations);
    if (!sheet)
        return nullptr;
    const bool cancelled = planSolve(m_restInput, input) == SolvePlan::Nothing;
    if (afterGesture && !cancelled && ledNear(m_liveInput.design, input.design))
        showOnNewTriangles(*sheet);
    const auto next = [this](SolverStatus::Stage stage) {
        m_status.stage = stage;
        if (!m_gesture) // whose surface is what the status is about
            publish(SolverStatus::State::Preparing);
    };
    next(SolverStatus::Stage::FewerTriangles);
    std::optional<SheetState> coarse = coarseStart(sheet->prepared, m_ghostCache, m_pool, m_preparing.get_token());
    if (coarse && !m_gesture && !afterGesture)
        showCoarse(*sheet, *coarse);
    next(SolverStatus::Stage::Equations);
    if (!factor(*sheet, restingTolerance))
        return nullptr;
    if (sheet->relaxation)
        startFromDesign(*sheet->relaxation, std::move(coarse));
    return m_preparing.stop_requested() ? nullptr : std::move(sheet);
}

/// The first that is seen of a design; later instead of what is far from it, as after undo: a surface of another
/// design for seconds is worse than one that moves by some millimetres more in the end.
void SolverWorker::showCoarse(const Sheet& sheet, const SheetState& coarse)
{
    auto surface = makeSurface(sheet.prepared.mesh, coarse, m_surfaceRevision + 1);
    CoverMove move;
    if (m_surface && (m_live || m_shownKept)) {
        move = moveBetween(*m_surface, *surface);
        if (!move.from || move.distance < farFromCoarse)
            return;
    }
    ++m_surfaceRevision;
    publishSurface(std::move(surface));
    m_from = std::move(move.from);
    m_designRevision = m_takenRevision;
    publish(SolverStatus::State::Preparing);
}

/// Where a gesture has led, on the triangles of what will be at rest.
void SolverWorker::showOnNewTriangles(const Sheet& sheet)
{
    const SewnMesh& mesh = sheet.prepared.mesh;
    if (!m_live || !m_live->relaxation || m_live->prepared.mesh.parts.size() != mesh.parts.size() ||
        !sheet.prepared.leftOut.empty())
        return;
    publishSurface(makeSurface(mesh, transferState(m_live->prepared.mesh, m_live->relaxation->state(), mesh),
                               ++m_surfaceRevision));
    m_designRevision = m_takenRevision;
    publish(SolverStatus::State::Preparing);
}

/// On the way to the first surface of a design each is shown that somebody could see; later the last one stays.
void SolverWorker::iterateResting()
{
    Relaxation& relaxation = *m_resting->relaxation;
    relaxation.iterate();
    if (m_gesture)
        return;
    const bool first = !m_live && !m_shownKept;
    m_status.iterations = relaxation.iterations();
    m_status.movement = relaxation.movement();
    if (relaxation.phase() == Relaxation::Phase::Failed ||
        m_sincePublished.elapsed() < (first ? wayInterval : countInterval))
        return;
    m_status.iterationsPerSecond = 1000 * relaxation.iterations() / std::max(1e-3, m_rateWatch.elapsed());
    if (first)
        publishSurface(surfaceOf(*m_resting));
    m_sincePublished.restart();
    publish(SolverStatus::State::Moving);
}

void SolverWorker::endResting()
{
    const Relaxation& relaxation = *m_resting->relaxation;
    const bool converged = relaxation.phase() == Relaxation::Phase::Converged;
    if (m_gesture && !converged) {
        m_resting.reset();
    } else if (relaxation.phase() == Relaxation::Phase::Failed) {
        failIn(*m_resting);
    } else if (m_gesture &&
               surfaceDistance(m_live->prepared.mesh, m_live->relaxation->state(), m_resting->prepared.mesh,
                               relaxation.state()) >= (m_live->standsIn ? springDistance : visibleDistance)) {
        m_restingWaits = true;
    } else {
        if (!converged)
            m_status.reason = {QT_TRANSLATE_NOOP("Message", "The surface still moves after %1 iterations."),
                               {std::to_string(relaxation.iterations())}};
        adoptResting();
    }
}

void SolverWorker::adoptResting()
{
    const SurfaceMeshPtr before = m_surface;
    const SurfaceMeshPtr after = surfaceOf(*m_resting);
    const bool stoodIn = m_live && m_live->standsIn;
    const bool seen =
        (!m_gesture || stoodIn) && before && (m_live || m_shownKept); // as it was, else only on the way
    CoverMove move = seen ? moveBetween(*before, *after) : CoverMove();
    if (strandedDistance(move.distance) > springDistance)
        m_status.sprang = move.distance;
    m_standIn.reset();
    if (m_gesture && stoodIn) {
        m_standIn = std::move(m_live);
        m_standInInput = m_liveInput;
    }
    m_live = std::move(m_resting);
    m_liveInput = m_restingInput;
    m_owed = SolvePlan::Nothing;
    m_shownKept.reset();
    m_field.reset();
    publishSurface(after);
    if (move.distance > visibleDistance)
        m_from = std::move(move.from);
    m_status.iterations = m_live->relaxation->iterations();
    m_status.movement = m_live->relaxation->movement();
    reportLive();
    m_restKept = false;
    m_restInput = m_restingInput;
    if (!m_gesture) {
        m_designRevision = m_takenRevision;
        keepResting();
    }
    beAtRest();
}

/// How much of the distance is no lag of the live surface behind the pointer: it had come to rest, or nearly so,
/// but elsewhere. mm.
double SolverWorker::strandedDistance(double distance) const
{
    constexpr double stepsToGo = 40; // that the last one is likely to have before it
    if (!m_live || planSolve(m_liveInput, m_restingInput) != SolvePlan::Nothing)
        return 0; // no gesture led here
    return distance - stepsToGo * m_live->relaxation->movement() * m_live->prepared.mesh.largestDiameter();
}

/// There is nothing to solve.
void SolverWorker::restEmpty()
{
    m_live.reset();
    m_shownKept.reset();
    m_report = {};
    m_designRevision = m_takenRevision;
    m_restKept = true;
    m_restInput = m_restingInput;
    m_atRest = true;
    m_status.resting = false;
    publish(SolverStatus::State::Idle);
    m_restStatus = m_status;
}

void SolverWorker::beAtRest()
{
    m_lastWhole.reset();
    m_atRest = true;
    m_status.resting = true;
    publish(SolverStatus::State::Settled);
    m_restStatus = m_status;
}

} // namespace bolster
