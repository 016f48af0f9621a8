#include "Solving.h"

#include "Output.h"
#include "ProgressLine.h"
#include "Project.h"

#include <algorithm>
#include <new>
#include <set>

namespace bolster::cli {

namespace {

/// The reason of the report: `bolster check` tells them all.
std::string firstOf(const Problems& errors)
{
    const std::string more = errors.size() > 1 ? " (and " + std::to_string(errors.size() - 1) + " more)" : "";
    return errors.empty() ? "" : errors.front().english() + more;
}

Problems withSeverity(const Problems& problems, Severity severity)
{
    Problems found;
    std::copy_if(problems.begin(), problems.end(), std::back_inserter(found),
                 [&](const Problem& problem) { return problem.severity == severity; });
    return found;
}

Problems errorsOf(const OpenedDesign& opened)
{
    Problems errors = withSeverity(opened.problems, Severity::Error);
    addMissingPatch(errors, opened.design);
    return errors;
}

/// With a word on the terminal about how far it is.
SolveResult solveShown(const OpenedDesign& opened, const SolveOptions& options, std::stop_token stop)
{
    ProgressLine line("preparing");
    return solveResting({opened.design, opened.files}, options, std::move(stop),
                        [&](int iteration, double movement) {
                            line.say("iteration " + std::to_string(iteration) + ", the cover moves by " +
                                     numberText(movement, 2) + " of its size");
                        });
}

SolveResult solveLeniently(const OpenedDesign& opened, Problems errors, const SolveOptions& options,
                           std::stop_token stop)
{
    SolveResult result = solveShown(opened, options, std::move(stop));
    addNew(errors, result.errors);
    result.leftOut = allLeftOut(errors, result.leftOut);
    result.errors = result.surface ? Problems() : errors;
    return result;
}

} // namespace

OpenedDesign openedShown(const QString& path)
{
    const ProgressLine line("reading");
    return openDesignOrProject(path);
}

void addMissingPatch(Problems& problems, const Design& design)
{
    bool hasPatch = false;
    design.each<Patch>([&](ElementId, const Patch&) { hasPatch = true; });
    if (!hasPatch && !hasErrors(problems))
        problems.push_back({settingsId,
                            {},
                            "elements",
                            {"the design has no patch yet: draw one, there is nothing to "
                             "cover a frame with",
                             {}}});
}

Problems allLeftOut(const Problems& errors, const Problems& leftOutBySolver)
{
    Problems all = errors;
    std::set<ElementId> wrong;
    for (const Problem& error : errors)
        wrong.insert(error.element);
    std::ranges::copy_if(leftOutBySolver, std::back_inserter(all),
                         [&](const Problem& problem) { return !wrong.contains(problem.element); });
    std::stable_sort(all.begin(), all.end(),
                     [](const Problem& a, const Problem& b) { return a.element < b.element; });
    return all;
}

SolveResult solveOpened(const OpenedDesign& opened, const SolveOptions& options, std::stop_token stop)
{
    const Problems errors = errorsOf(opened);
    SolveResult result;
    try {
        const auto tooFine = std::ranges::find_if(errors, [](const Problem& error) {
            return error.element == settingsId && error.field == "edge_length"; // nothing can be left out for it
        });
        if (tooFine != errors.end())
            result.errors = {*tooFine};
        else if (opened.readable && options.lenient)
            result = solveLeniently(opened, errors, options, std::move(stop));
        else if (errors.empty())
            result = solveShown(opened, options, std::move(stop));
        else
            result.errors = errors;
    } catch (const std::bad_alloc&) {
        result = {};
        result.reason = {"there is not enough memory for this design; choose a larger edge length", {}};
    }

    if (result.status == SolveResult::Status::Cancelled)
        result.reason = {"interrupted", {}};
    else if (result.reason.empty() && !result.errors.empty())
        result.reason = {firstOf(result.errors), {}};
    addNew(result.warnings, withSeverity(opened.problems, Severity::Warning));
    return result;
}

SolveResult interruptedResult()
{
    SolveResult result;
    result.status = SolveResult::Status::Cancelled;
    result.reason = {"interrupted", {}};
    return result;
}

void printFindings(const SolveResult& result)
{
    printProblems(result.errors);
    for (const Problem& problem : result.leftOut)
        printError("left out: " + problem.english());
    printProblems(result.warnings);
    if (!result.reason.empty() && result.errors.empty())
        printError("error: " + result.reason.english());
}

bool printErrors(const Problems& problems)
{
    for (const Problem& problem : withSeverity(problems, Severity::Error))
        printError("error: " + problem.english());
    return hasErrors(problems);
}

} // namespace bolster::cli
