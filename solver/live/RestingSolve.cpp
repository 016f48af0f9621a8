#include "RestingSolve.h"

#include "CoarseStart.h"
#include "DesignCheck.h"
#include "MakeGhosts.h"
#include "OutlineSampling.h"
#include "Relaxation.h"
#include "ScanMeasure.h"
#include "SolveFailure.h"
#include "Stopwatch.h"
#include "SurfaceMeasures.h"
#include "SurfacePublisher.h"

#include <algorithm>

namespace bolster {

namespace {

Message firstOf(const Problems& problems)
{
    const auto error = std::find_if(problems.begin(), problems.end(),
                                    [](const Problem& p) { return p.severity == Severity::Error; });
    return {error->label.empty() ? QT_TRANSLATE_NOOP("Message", "The design cannot be solved: %2")
                                 : QT_TRANSLATE_NOOP("Message", "%1: %2"),
            {error->label, error->message.english()}};
}

bool hasPressure(const SewnMesh& mesh)
{
    return std::ranges::any_of(mesh.parts, [](const auto& part) { return part.material.pressure != 0; });
}

/// Why the iterations did not end.
Message unrest(const Relaxation& solve, const SewnMesh& mesh)
{
    const double diameter = mesh.largestDiameter();
    constexpr int enough = 1000;      // iterations: many times what covers take
    constexpr double settling = 1e-3; // D: what comes to rest moves less by then
    const std::string iterations = std::to_string(solve.iterations());
    if (solve.iterations() >= enough && solve.movement() > settling)
        return {hasPressure(mesh)
                    ? QT_TRANSLATE_NOOP("Message",
                                        "After %1 iterations the surface still moves by %2 mm in each: it does not "
                                        "come to rest. Lower the pressure, or make curves as long as the outlines "
                                        "they hold.")
                    : QT_TRANSLATE_NOOP("Message",
                                        "After %1 iterations the surface still moves by %2 mm in each: it does not "
                                        "come to rest. Make curves as long as the outlines they hold, or try other "
                                        "mesh edges."),
                {iterations, numberText(solve.movement() * diameter, 2)}};
    constexpr double told = 0.1; // D: a longer way is a guess
    if (solve.estimate() > told)
        return {QT_TRANSLATE_NOOP("Message", "After %1 iterations it cannot be told yet where the surface comes to "
                                             "rest. Allow more iterations."),
                {iterations}};
    return {QT_TRANSLATE_NOOP("Message", "After %1 iterations the surface still moves by an estimated %2 mm. Allow "
                                         "more iterations."),
            {iterations, numberText(solve.estimate() * diameter, 2)}};
}

Problem flippedWarning(std::int64_t flipped, std::int64_t triangles)
{
    return {settingsId,
            {},
            {},
            {QT_TRANSLATE_NOOP("Message",
                               "%1 of %2 triangles of the cover lie upside down. Look for cloth pressed into too "
                               "little room, or a bending length that is long for its patch."),
             {std::to_string(flipped), std::to_string(triangles)}},
            Severity::Warning};
}

SolveResult failed(SolveResult result, Message reason)
{
    result.status = SolveResult::Status::Failed;
    result.reason = std::move(reason);
    return result;
}

/// Its triangles are not wanted again.
std::optional<PreparedSheet> prepareOnce(const SolveInput& input, WorkerPool& pool, const std::stop_token& stop)
{
    TriangulationCache cache;
    return prepareSheet(input, cache, pool, stop);
}

SolveResult solve(const SolveInput& input, const SolveOptions& options, const std::stop_token& stop,
                  const std::function<void(int, double)>& progress)
{
    Stopwatch watch;
    SolveResult result;
    WorkerPool pool(options.threads);
    std::optional<PreparedSheet> sheet = prepareOnce(input, pool, stop);
    if (!sheet) {
        result.status = SolveResult::Status::Cancelled;
        return result;
    }
    result.errors = sheet->errors;
    result.warnings = sheet->warnings;
    if (options.lenient)
        result.leftOut = sheet->leftOut;
    else if (hasErrors(sheet->errors))
        return failed(std::move(result), firstOf(sheet->errors));
    if (sheet->mesh.parts.empty())
        return failed(
            std::move(result),
            {QT_TRANSLATE_NOOP("Message", "There is no patch to solve. Add a patch to the pattern."), {}});

    GhostCache ghostCache;
    std::optional<SheetState> coarse;
    if (!options.oneLevel)
        coarse = coarseStart(*sheet, ghostCache, pool, stop);
    Relaxation relaxation(
        sheet->mesh, pool, options.tolerance,
        makeGhosts({sheet->design, sheet->files}, sheet->mesh, ghostCache, result.warnings, pool, stop), stop);
    if (stop.stop_requested()) {
        result.status = SolveResult::Status::Cancelled;
        return result;
    }
    if (options.oneLevel)
        relaxation.doNotMix();
    startFromDesign(relaxation, std::move(coarse));
    while (relaxation.phase() == Relaxation::Phase::Running && relaxation.iterations() < options.maxIterations) {
        if (stop.stop_requested()) {
            result.status = SolveResult::Status::Cancelled;
            return result;
        }
        relaxation.iterate();
        if (progress)
            progress(relaxation.iterations(), relaxation.movement());
    }
    if (relaxation.phase() == Relaxation::Phase::Failed)
        return failed(std::move(result), explainFailure(relaxation, sheet->design).reason);

    if (relaxation.phase() == Relaxation::Phase::Converged) {
        result.status = SolveResult::Status::Solved;
    } else {
        result.status = SolveResult::Status::NotConverged;
        result.reason = unrest(relaxation, sheet->mesh);
    }
    relaxation.release();
    result.report = reportOn(*sheet, relaxation);
    result.report.time.total = watch.elapsed(); // with what lies between the stages
    if (result.report.flippedTriangles > 0)
        result.warnings.push_back(flippedWarning(result.report.flippedTriangles, result.report.triangles));
    result.surface = makeSurface(sheet->mesh, relaxation.state(), 0);
    result.report.scans = measureScans({sheet->design, sheet->files}, *result.surface, ghostCache.scans, pool);
    return result;
}

} // namespace

SolveResult solveResting(const SolveInput& input, const SolveOptions& options, std::stop_token stop,
                         const std::function<void(int, double)>& progress)
{
    try {
        return solve(input, options, stop, progress);
    } catch (const std::exception& error) {
        return failed({}, failureMessage(error));
    }
}

Problems checkSolvable(const Design& design, const std::stop_token& stop)
{
    WorkerPool pool(0);
    std::optional<PreparedSheet> sheet = prepareOnce({design, {}}, pool, stop);
    if (!sheet)
        return {};
    Problems problems = std::move(sheet->errors);
    std::ranges::move(sheet->warnings, std::back_inserter(problems));
    return problems;
}

Message tooNarrowForEdges(const Design& design, const std::stop_token& stop)
{
    std::string names;
    for (const Problem& problem : checkSolvable(design, stop))
        if (const Patch* patch = design.find<Patch>(problem.element);
            patch && problem.severity == Severity::Error && problem.field == "outline")
            names.append(names.empty() ? "" : ", ").append(patch->name);
    if (names.empty())
        return {};
    return {QT_TRANSLATE_NOOP("Message",
                              "Too narrow for the triangles of the cover, whose edges are %1 mm long, so that "
                              "it cannot be solved: %2. Make the mesh edges shorter, or join them to what "
                              "lies beside them"),
            {numberText(design.settings().edgeLength, 3), names}};
}

} // namespace bolster
