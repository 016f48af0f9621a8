#include "WarmCover.h"

#include "CoarseStart.h"
#include "Pulls.h"
#include "SeamEnds.h"
#include "SheetFollow.h"
#include "SolveFailure.h"
#include "StateTransfer.h"
#include "SurfacePublisher.h"

#include <algorithm>
#include <utility>

namespace bolster {

namespace {

Message firstError(const Problems& problems)
{
    const auto error = std::ranges::find(problems, Severity::Error, &Problem::severity);
    if (error == problems.end())
        return {QT_TRANSLATE_NOOP("Message", "There is no patch to solve. Add a patch to the pattern."), {}};
    return {QT_TRANSLATE_NOOP("Message", "%1: %2"), {error->label, error->message.english()}};
}

} // namespace

WarmCover::WarmCover(const SolveInput& input, const WarmOrder& order, const std::stop_token& stop)
    : m_order(order)
    , m_files(input.files)
    , m_pool(std::make_unique<WorkerPool>(order.threads))
{
    if (!prepare(asWanted(input.design), stop))
        return;
    const bool asDesigned = m_order.edgeLength <= 0;
    startFromDesign(*m_relaxation, asDesigned ? coarseStart(*m_sheet, m_ghostCache, *m_pool, stop) : std::nullopt);
    if (comeToRest(m_order.mostIterations, stop)) {
        makeHome();
        m_homeFactors = m_relaxation->factorings();
    }
}

/// On the triangles that were ordered, and without what would pull the cover to where it is measured.
SolveInput WarmCover::asWanted(const Design& design) const
{
    const SolveInput input{withoutPulls(design), m_files};
    return m_order.edgeLength > 0 ? withEdgeLength(input, m_order.edgeLength) : input;
}

bool WarmCover::prepare(const SolveInput& input, const std::stop_token& stop)
{
    TriangulationCache triangles;
    std::optional<PreparedSheet> sheet = prepareSheet(input, triangles, *m_pool, stop);
    if (!sheet)
        return false;
    if (hasErrors(sheet->errors) || sheet->mesh.parts.empty()) {
        m_problem = firstError(sheet->errors);
        return false;
    }
    m_relaxation.reset();
    m_warp.reset();
    m_sheet = std::make_unique<PreparedSheet>(std::move(*sheet));
    m_relaxation = std::make_unique<Relaxation>(m_sheet->mesh, *m_pool, m_order.tolerance, ghosts(stop), stop);
    m_now = input;
    m_sampled = m_sheet->design;
    m_parameters.clear();
    for (const OutlineSampling::Outline& outline : m_sheet->sampling.outlines)
        m_parameters.push_back(outline.parameters);
    return !stop.stop_requested();
}

/// What is asked of the matrices follows from home and this design alone. Ends of seams that have moved along their
/// outlines are no reason for other triangles here: the samples slide.
SolvePlan WarmCover::planFor(const SolveInput& input) const
{
    SolvePlan plan = SolvePlan::Nothing;
    for (const SolveInput* from : {&m_now, &m_homeInput}) {
        const Design still = withStretchesOf(input.design, from->design);
        plan = together(plan, planSolve(*from, {still, input.files}));
        if (!(still == input.design))
            plan = together(plan, SolvePlan::Warp);
    }
    return plan;
}

/// False when ends of seams have passed each other.
bool WarmCover::slideSamples(const Design& design)
{
    std::vector<std::vector<double>> slid = m_parameters;
    if (!(withStretchesOf(design, m_sampled) == design))
        for (std::size_t o = 0; o < slid.size(); ++o) {
            const ElementId patch = m_sheet->sampling.outlines[o].patch;
            std::optional<std::vector<double>> parameters = slidSamples(m_parameters[o], m_sampled, design, patch);
            if (!parameters)
                return false;
            slid[o] = std::move(*parameters);
        }
    for (std::size_t o = 0; o < slid.size(); ++o)
        m_sheet->sampling.outlines[o].parameters = std::move(slid[o]);
    return true;
}

Ghosts WarmCover::ghosts(const std::stop_token& stop)
{
    Problems said; // who solves the design tells them
    return makeGhosts({m_sheet->design, m_sheet->files}, m_sheet->mesh, m_ghostCache, said, *m_pool, stop);
}

/// The same triangles for another design.
bool WarmCover::adapt(const SolveInput& input, const std::stop_token& stop)
{
    const SolvePlan plan = planFor(input);
    // Outlines and matrix values together ask for a new triangulation in a gesture; here they have the time.
    const bool both =
        plan == SolvePlan::Rebuild && m_now.design.settings().edgeLength == input.design.settings().edgeLength;
    if (plan > SolvePlan::Warp && !both)
        return false;
    const bool warps = both || plan == SolvePlan::Warp;
    if (warps && !slideSamples(input.design))
        return false;
    Problems problems;
    if (!followDesign(*m_sheet, m_warp, input, both ? SolvePlan::Warp : plan, *m_pool, problems))
        return false;
    m_now = input;
    if (hasErrors(problems)) {
        m_problem = firstError(problems);
        return false;
    }
    const bool refactors = both || plan == SolvePlan::Refactor;
    if (warps)
        m_relaxation->reshape(ghosts(stop));
    if (refactors)
        m_relaxation->refactor(ghosts(stop));
    else if (plan != SolvePlan::Warp && plan != SolvePlan::Nothing)
        m_relaxation->retarget(ghosts(stop));
    return true;
}

/// From home.
bool WarmCover::startFollowing(const Design& design, const std::stop_token& stop)
{
    m_problem = {};
    m_restsAt.reset();
    if (!m_relaxation)
        return false;
    if (!factorsAreHome()) {
        if (!adapt(m_homeInput, stop))
            return false;
        m_relaxation->refactor(ghosts(stop));
        m_homeFactors = m_relaxation->factorings();
    }
    if (!adapt(asWanted(design), stop))
        return false;
    m_relaxation->startNear(m_home);
    return true;
}

bool WarmCover::follow(const Design& design, const std::stop_token& stop)
{
    if (!startFollowing(design, stop) || !comeToRest(m_order.mostWarmIterations, stop))
        return false;
    m_restsAt = design;
    return true;
}

bool WarmCover::lookBeside(const Design& design, const std::stop_token& stop)
{
    if (m_order.iterationsBeside <= 0)
        return follow(design, stop);
    if (!startFollowing(design, stop))
        return false;
    const bool rests = comeToRest(m_order.iterationsBeside, stop);
    if (rests || m_relaxation->phase() == Relaxation::Phase::Running)
        m_problem = {};
    return !stop.stop_requested() && m_problem.empty();
}

bool WarmCover::moveHome(const Design& design, const std::stop_token& stop)
{
    if (m_restsAt == design || follow(design, stop)) {
        makeHome();
        return true;
    }
    if (!m_relaxation || stop.stop_requested())
        return false;
    // The relaxation works on the sheet's mesh, which stays where it is in memory.
    std::unique_ptr<PreparedSheet> sheet = std::move(m_sheet);
    std::unique_ptr<Relaxation> relaxation = std::move(m_relaxation);
    std::optional<PatternWarp> warp = std::exchange(m_warp, std::nullopt);
    SolveInput now = m_now;
    Design sampled = m_sampled;
    std::vector<std::vector<double>> parameters = m_parameters;
    m_problem = {};
    if (prepare(asWanted(design), stop)) {
        m_relaxation->startNear(transferState(sheet->mesh, m_home, m_sheet->mesh));
        if (comeToRest(m_order.mostIterations, stop)) {
            makeHome();
            return true;
        }
    }
    m_relaxation = std::move(relaxation);
    m_sheet = std::move(sheet);
    m_warp = std::move(warp);
    m_now = std::move(now);
    m_sampled = std::move(sampled);
    m_parameters = std::move(parameters);
    return false;
}

bool WarmCover::comeToRest(int mostIterations, const std::stop_token& stop)
{
    while (m_relaxation->phase() == Relaxation::Phase::Running && m_relaxation->iterations() < mostIterations &&
           !stop.stop_requested())
        m_relaxation->iterate();
    if (m_relaxation->phase() == Relaxation::Phase::Converged)
        return true;
    if (m_relaxation->phase() == Relaxation::Phase::Failed)
        m_problem = explainFailure(*m_relaxation, m_sheet->design).reason;
    else if (!stop.stop_requested())
        m_problem = {QT_TRANSLATE_NOOP("Message", "The cover does not come to rest."), {}};
    return false;
}

void WarmCover::makeHome()
{
    m_home = m_relaxation->state();
    m_restsAt.reset();
    m_homeInput = m_now;
    m_homeFactors = 0; // the present ones are near, but of another design
}

SurfaceMeshPtr WarmCover::surface() const
{
    return makeSurface(m_sheet->mesh, m_relaxation->state(), 0);
}

} // namespace bolster
