#include "SolverWorker.h"

#include "ScanMeasure.h"
#include "SolveFailure.h"
#include "SurfaceMeasures.h"
#include "SurfacePublisher.h"

#include <exception>
#include <new>
#include <utility>

namespace bolster {

namespace {

constexpr int mostIterations = 5000;
constexpr std::size_t mostKept = std::size_t(256) << 20; // bytes

} // namespace

SolverWorker::SolverWorker(std::function<void()> wake, std::shared_ptr<RestingCache> kept)
    : m_wake(std::move(wake))
    , m_keptIsShared(kept != nullptr)
    , m_kept(kept ? std::move(kept) : std::make_shared<RestingCache>(mostKept))
{}

void SolverWorker::request(Request request)
{
    const std::lock_guard lock(m_requestMutex); // or it might stop what is made for itself
    const bool passing = request.passing;
    // What does not touch the cover need not begin anew what may have taken seconds.
    const bool goesOn =
        m_preparesRest && !passing && planSolve(*m_preparesRest, request.input) == SolvePlan::Nothing;
    m_in.put(std::move(request));
    if ((!passing || m_preparesRest) && !goesOn)
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
    const bool follows = m_gesture && m_live && !m_atRest;
    if (std::optional<Request> request = takeRequest())
        begin(std::move(*request));
    else if (follows && running(*m_live))
        iterateLive();
    else if (follows && !m_liveEnded)
        endLive();
    else if (m_resting && running(*m_resting))
        iterateResting();
    else if (m_resting && !m_restingWaits)
        endResting();
    else if (m_shownKept && !m_live)
        continueKept();
    else if (m_atRest && prepareStandIn())
        ;
    else
        return false;
    return true;
}

/// Of the design before nothing stays: it may have been a large one.
void SolverWorker::forgetAll()
{
    m_live.reset();
    m_lastWhole.reset();
    m_standIn.reset();
    m_resting.reset();
    m_surface.reset();
    m_from.reset();
    m_field.reset();
    m_shownKept.reset();
    m_triangulations = {};
    m_standInTriangulations = {};
    m_liveInput = m_restingInput = m_restInput = m_standInInput = {};
    if (!m_keptIsShared)
        m_kept->clear();
    m_atRest = false;
    m_status = {};
    m_report = {};
}

void SolverWorker::begin(Request request)
{
    if (std::exchange(m_opening, request.opening) != request.opening)
        forgetAll();
    // While somebody drags the window has to draw.
    m_pool.use(request.passing ? m_pool.threads() / 2 : m_pool.threads());
    if (request.passing)
        beginLive(std::move(request));
    else
        beginRest(std::move(request));
}

/// Null when it was given up.
std::unique_ptr<SolverWorker::Sheet> SolverWorker::makeSheet(const SolveInput& input, double tolerance)
{
    std::unique_ptr<Sheet> sheet = prepare(input, m_triangulations);
    return sheet && factor(*sheet, tolerance) ? std::move(sheet) : nullptr;
}

/// Its triangles. Null when it was given up.
std::unique_ptr<SolverWorker::Sheet> SolverWorker::prepare(const SolveInput& input,
                                                           TriangulationCache& triangulations)
{
    std::optional<PreparedSheet> prepared = prepareSheet(input, triangulations, m_pool, m_preparing.get_token());
    if (!prepared)
        return nullptr;
    auto sheet = std::make_unique<Sheet>();
    sheet->prepared = std::move(*prepared);
    return sheet;
}

/// Its equations, unless there is nothing to solve. False when it was given up.
bool SolverWorker::factor(Sheet& sheet, double tolerance)
{
    const std::stop_token stop = m_preparing.get_token();
    if (!sheet.prepared.mesh.parts.empty())
        sheet.relaxation = std::make_unique<Relaxation>(sheet.prepared.mesh, m_pool, tolerance,
                                                        ghostsFor(sheet.prepared, sheet.prepared.warnings), stop);
    return !stop.stop_requested();
}

Ghosts SolverWorker::ghostsFor(const PreparedSheet& sheet, Problems& problems)
{
    return makeGhosts({sheet.design, sheet.files}, sheet.mesh, m_ghostCache, problems, m_pool,
                      m_preparing.get_token());
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
            fail({failureMessage(error), {}});
            return;
        } catch (const std::bad_alloc&) {
        }
    }
}

void SolverWorker::failIn(const Sheet& sheet)
{
    fail(explainFailure(*sheet.relaxation, sheet.prepared.design)); // before the sheet is gone
}

void SolverWorker::fail(SolveFailure failure)
{
    m_resting.reset();
    m_live.reset(); // the next request starts anew; the published surface stays
    m_lastWhole.reset();
    m_standIn.reset();
    m_shownKept.reset();
    m_atRest = false;
    m_designRevision = m_takenRevision;
    m_status.resting = false;
    m_status.reason = std::move(failure.reason);
    m_status.culprit = failure.element;
    publish(SolverStatus::State::Failed);
}

SurfaceMeshPtr SolverWorker::surfaceOf(const Sheet& sheet)
{
    return makeSurface(sheet.prepared.mesh, sheet.relaxation->state(), ++m_surfaceRevision);
}

void SolverWorker::publishSurface(SurfaceMeshPtr surface)
{
    m_surface = std::move(surface);
    m_from.reset();
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
    if (m_out.put({m_designRevision, m_opening, m_surface, m_from, m_status, m_report, m_field}))
        m_wake();
}

} // namespace bolster
