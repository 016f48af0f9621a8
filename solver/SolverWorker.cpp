#include "SolverWorker.h"

#include "DesignCheck.h"
#include "Relief.h"
#include "ScanMeasure.h"
#include "SolveFailure.h"
#include "StateTransfer.h"
#include "SurfaceMeasures.h"
#include "SurfacePublisher.h"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

namespace bolster {

namespace {

constexpr double liveTolerance = 1e-5; // relative to D
constexpr double restingTolerance = 1e-6;
constexpr int mostIterations = 5000;
constexpr double publishInterval = 15; // ms: nobody sees more
constexpr double silentDistance = 0.5; // mm: a resting surface this near replaces the live one unasked

bool sameElements(const Design& a, const Design& b)
{
    return std::equal(a.elements().begin(), a.elements().end(), b.elements().begin(), b.elements().end(),
                      [](const auto& x, const auto& y) { return x.first == y.first; });
}

} // namespace

SolverWorker::SolverWorker(std::function<void()> wake)
    : m_wake(std::move(wake))
{}

void SolverWorker::request(Request request)
{
    const std::lock_guard lock(m_requestMutex); // or it might stop what is made for itself
    const bool passing = request.passing;
    m_in.put(std::move(request));
    if (!passing)
        m_preparing.request_stop();
}

std::optional<SolverWorker::Request> SolverWorker::takeRequest()
{
    std::stop_source preparing; // before the request is taken, or it would be lost if there were no memory for it
    const std::lock_guard lock(m_requestMutex);
    std::optional<Request> request = m_in.take();
    if (request) {
        m_preparing = std::move(preparing);
        m_takenRevision = request->revision;
    }
    return request;
}

void SolverWorker::run(std::stop_token stop)
{
    const std::stop_callback whenEnding(stop, [this] {
        const std::lock_guard lock(m_requestMutex);
        m_preparing.request_stop();
    });
    while (!stop.stop_requested()) {
        bool busy = false;
        try {
            busy = step();
        } catch (const std::exception& error) {
            failBy(error);
        }
        if (!busy)
            m_in.wait(stop);
    }
}

bool SolverWorker::running(const Sheet& sheet)
{
    return sheet.relaxation->phase() == Relaxation::Phase::Running &&
           sheet.relaxation->iterations() < mostIterations;
}

/// A little work. False when there is none left.
bool SolverWorker::step()
{
    if (std::optional<Request> request = takeRequest())
        begin(std::move(*request));
    else if (m_live && running(*m_live))
        iterateLive();
    else if (m_live && !m_resting && !m_restingDone)
        endLive();
    else if (m_resting && !m_status.restingDistance) // once known it waits to be asked for
        iterateResting();
    else
        return false;
    return true;
}

SolvePlan SolverWorker::planFor(const Request& request)
{
    if (!m_live)
        return SolvePlan::Resew;
    const SolvePlan plan = together(planSolve(m_input, request.input), std::exchange(m_owed, SolvePlan::Nothing));
    const bool warped = plan == SolvePlan::Warp || m_live->warp;
    return warped && !request.passing ? std::max(plan, SolvePlan::Rebuild) : plan;
}

void SolverWorker::begin(Request request)
{
    if (std::exchange(m_opening, request.opening) != request.opening) {
        m_live.reset();
        m_lastWhole.reset();
        m_resting.reset();
        m_surface.reset();
        m_status = {};
        m_report = {};
    }
    const SolvePlan plan = planFor(request);
    const bool light = plan > SolvePlan::Nothing && plan < SolvePlan::Rebuild;
    // Still about the last design: its surface is there, but what follows may take its time.
    const SolverStatus statusBefore = m_status;
    if (!light && plan != SolvePlan::Nothing && m_status.state != SolverStatus::State::Moving)
        publish(SolverStatus::State::Preparing);
    const SolveInput inputBefore = std::exchange(m_input, std::move(request.input));
    m_designRevision = request.revision;
    m_settleWanted = request.settle;
    if (plan == SolvePlan::Nothing || (plan == SolvePlan::Republish && republishLive(m_input.design))) {
        if (m_settleWanted && m_resting && m_status.restingDistance)
            adoptResting();
        publish(m_status.state);
        return;
    }
    if (plan != SolvePlan::Republish)
        m_field.reset();
    const bool retargeted = light && plan != SolvePlan::Republish && retargetLive(m_input, plan);
    if (!retargeted && !rebuildLive(m_input, plan == SolvePlan::Resew)) {
        m_input = inputBefore;                      // given up for a newer request, which starts from what there is
        m_owed = light ? plan : SolvePlan::Nothing; // and may be half new then
        m_status = statusBefore;
        return;
    }
    m_resting.reset();
    m_restingDone = false;
    m_status.resting = false;
    m_status.restingDistance.reset();
    m_status.reason = {};
    m_status.iterations = 0;
    m_rateWatch.restart();
    m_rateCount = 0;
    if (m_live)
        iterateLive();
    else
        publish(SolverStatus::State::Idle);
}

/// Keeps the solution. False when the change asks for more after all.
bool SolverWorker::republishLive(const Design& design)
{
    const Design usable = usablePart(design, checkDesign(design));
    if (!sameElements(usable, m_live->prepared.design))
        return false;
    for (Sheet* sheet : {m_live.get(), m_resting.get()})
        if (sheet) {
            sheet->prepared.design = usable;
            updateReliefs(sheet->prepared.mesh, usable);
        }
    publishSurface();
    if (m_status.state == SolverStatus::State::Settled)
        reportLive();
    return true;
}

/// Keeps triangles, and samples but for their points. False when the change asks for more after all, or when it was
/// given up.
bool SolverWorker::retargetLive(const SolveInput& input, SolvePlan plan)
{
    Problems problems = checkDesign(input.design);
    const Design usable = usablePart(input.design, problems);
    PreparedSheet& prepared = m_live->prepared;
    if (!sameElements(usable, prepared.design))
        return false;
    OutlineSampling sampling = prepared.sampling;
    if (plan == SolvePlan::Warp) {
        if (!resample(sampling, usable) || !warpLive(sampling))
            return false;
    } else {
        retarget(sampling, usable);
        if (!sampling.problems.empty())
            return false;
    }
    prepared.sampling = std::move(sampling);
    prepared.design = usable;
    prepared.files = input.files;
    updateTargets(prepared.mesh, prepared.sampling);
    updateMaterials(prepared.mesh, usable);
    if (plan == SolvePlan::Warp)
        prepared.mesh.reliefs = makeReliefs(prepared.mesh, prepared.sampling, usable);
    else
        updateReliefs(prepared.mesh, usable);
    m_live->canonical = false;
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

/// False when the triangles would be too distorted.
bool SolverWorker::warpLive(const OutlineSampling& sampling)
{
    SewnMesh& mesh = m_live->prepared.mesh;
    if (!m_live->warp)
        m_live->warp.emplace(mesh);
    std::optional<std::vector<Vec2>> pattern = m_live->warp->warped(mesh, sampling);
    if (pattern)
        reshape(mesh, std::move(*pattern));
    return pattern.has_value();
}

/// False when it was given up.
bool SolverWorker::rebuildLive(const SolveInput& input, bool torn)
{
    const bool first = !m_live;
    std::unique_ptr<Sheet> next = makeSheet(input, first ? restingTolerance : liveTolerance);
    if (!next)
        return false;
    m_status.problems = next->prepared.errors;
    m_status.problems.insert(m_status.problems.end(), next->prepared.warnings.begin(),
                             next->prepared.warnings.end());
    if (next->prepared.mesh.parts.empty()) {
        m_live.reset();
        m_surface = makeSurface(next->prepared.mesh, {}, ++m_surfaceRevision);
        return true;
    }
    if (first) {
        next->canonical = true;
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

/// Null when it was given up.
std::unique_ptr<SolverWorker::Sheet> SolverWorker::makeSheet(const SolveInput& input, double tolerance)
{
    const std::stop_token stop = m_preparing.get_token();
    std::optional<PreparedSheet> prepared = prepareSheet(input, m_cache, stop);
    if (!prepared)
        return nullptr;
    auto sheet = std::make_unique<Sheet>();
    sheet->prepared = std::move(*prepared);
    if (!sheet->prepared.mesh.parts.empty())
        sheet->relaxation = std::make_unique<Relaxation>(
            sheet->prepared.mesh, m_pool, tolerance, ghostsFor(sheet->prepared, sheet->prepared.warnings), stop);
    return stop.stop_requested() ? nullptr : std::move(sheet);
}

Ghosts SolverWorker::ghostsFor(const PreparedSheet& sheet, Problems& problems)
{
    return makeGhosts({sheet.design, sheet.files}, sheet.mesh, m_ghostCache, problems, m_pool,
                      m_preparing.get_token());
}

/// One iteration, and a published surface when somebody could see it.
void SolverWorker::iterateLive()
{
    Relaxation& relaxation = *m_live->relaxation;
    relaxation.iterate();
    if (relaxation.phase() == Relaxation::Phase::Failed) {
        fail(relaxation.reason());
        return;
    }
    ++m_rateCount;
    const bool first = m_status.iterations == 0;
    m_status.iterations = relaxation.iterations();
    m_status.movement = relaxation.movement();
    if (first || m_sincePublished.elapsed() >= publishInterval) {
        m_status.iterationsPerSecond = 1000 * m_rateCount / std::max(1e-3, m_rateWatch.elapsed());
        publishSurface();
        publish(SolverStatus::State::Moving);
    }
}

/// The live surface has converged: report it, and find out what the resting one is.
void SolverWorker::endLive()
{
    const bool converged = m_live->relaxation->phase() == Relaxation::Phase::Converged;
    if (!converged)
        m_status.reason = {QT_TRANSLATE_NOOP("Message", "The surface still moves after %1 iterations."),
                           {std::to_string(m_live->relaxation->iterations())}};
    if (m_live->stale) {
        // The samples catch up with curves that have moved; the surface goes on from where it is.
        if (rebuildLive(m_input, false) && !m_live)
            publish(SolverStatus::State::Idle);
        return;
    }
    m_status.resting = m_live->canonical && converged;
    m_restingDone = m_live->canonical;
    publishSurface();
    reportLive();
    publish(SolverStatus::State::Settled);
    if (!m_restingDone)
        beginResting();
}

void SolverWorker::beginResting()
{
    m_resting = makeSheet(m_input, restingTolerance);
    if (!m_resting)
        return; // a newer request is there
    if (!m_resting->relaxation) {
        m_resting.reset();
        m_restingDone = true;
        return;
    }
    m_resting->canonical = true;
    m_resting->relaxation->startCanonically();
}

void SolverWorker::iterateResting()
{
    Relaxation& relaxation = *m_resting->relaxation;
    if (running(*m_resting)) {
        relaxation.iterate();
        return;
    }
    m_restingDone = true;
    if (relaxation.phase() != Relaxation::Phase::Converged) {
        m_resting.reset();
        return;
    }
    const double distance = surfaceDistance(m_live->prepared.mesh, m_live->relaxation->state(),
                                            m_resting->prepared.mesh, relaxation.state());
    if (distance < silentDistance || m_settleWanted) {
        adoptResting();
        return;
    }
    m_status.restingDistance = distance;
    publish(SolverStatus::State::Settled);
}

void SolverWorker::adoptResting()
{
    m_live = std::move(m_resting);
    m_restingDone = true;
    m_status.restingDistance.reset();
    m_status.resting = true;
    m_status.iterations = m_live->relaxation->iterations();
    publishSurface();
    reportLive();
    publish(SolverStatus::State::Settled);
}

/// On the surface that was published last.
void SolverWorker::reportLive()
{
    const PreparedSheet& prepared = m_live->prepared;
    m_report = reportOn(prepared, *m_live->relaxation);
    m_report.scans = measureScans({prepared.design, prepared.files}, *m_surface, m_ghostCache.scans, m_pool);
}

void SolverWorker::failBy(const std::exception& error)
{
    constexpr int attempts = 2; // to say so takes a little memory, which the first one has freed
    for (int attempt = 0; attempt < attempts; ++attempt) {
        try {
            fail(failureMessage(error));
            return;
        } catch (const std::bad_alloc&) {
        }
    }
}

void SolverWorker::fail(Message reason)
{
    m_resting.reset();
    m_live.reset(); // the next request starts anew; the published surface stays
    m_restingDone = true;
    m_designRevision = m_takenRevision;
    m_status.reason = std::move(reason);
    publish(SolverStatus::State::Failed);
}

void SolverWorker::publishSurface()
{
    m_surface = makeSurface(m_live->prepared.mesh, m_live->relaxation->state(), ++m_surfaceRevision);
    m_sincePublished.restart();
}

void SolverWorker::updateField()
{
    if (!m_drawsField || !m_live) {
        m_field.reset();
    } else if (!m_field) {
        auto picture = std::make_shared<FieldPicture>();
        for (const auto& source : m_live->relaxation->ghosts())
            source->draw(*picture);
        m_field = std::move(picture);
    }
}

void SolverWorker::publish(SolverStatus::State state)
{
    m_status.state = state;
    updateField();
    if (m_out.put({m_designRevision, m_opening, m_surface, m_status, m_report, m_field}))
        m_wake();
}

} // namespace bolster
