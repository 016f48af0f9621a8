#include "CauseFinder.h"
#include "DistinctFiles.h"
#include "FitTargetFiles.h"
#include "Interrupt.h"
#include "Output.h"
#include "OutputFiles.h"
#include "ProgressLine.h"
#include "Solving.h"
#include "Subcommands.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace bolster::cli {

const char* const explainHelp = R"(Usage: bolster explain DESIGN [options]

Says why a piece that was built is not as its design: which one cause explains best
how far its scan lies from the cover. Causes are foam that is thicker or harder, the
allowance of a seam, a piece that is larger or smaller, a fixation curve elsewhere,
and one side of a seam sewn shifted.

Options:
  --scan FILE           points or mesh of the piece (OBJ, PLY, E57 ...), where it lies in
                        the design; without this the scan of the design
  --sound FILE          the same of a piece that is as it should be: where that lies
                        elsewhere than the cover no cause is looked for
  --edge MM             edges of the triangles (the design's); longer ones are faster
  --solve N             causes whose covers are solved, after all have been looked at by
                        derivatives (5)
  --unit mm|cm|m|in|ft  what the numbers in files are (what they say, or mm)
  --up y|z              what points up in files (what they say, or z)
  --threads N           use N threads (0: as many as the machine has)
  --report FILE.json    all causes, ranked

Exit code:
  0  done
  1  an output cannot be written, interrupted, or no cover
  2  the design or FILE cannot be used, or wrong usage
)";

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array explainRules = {OptionRule{"--scan", true},    OptionRule{"--sound", true},
                                     OptionRule{"--edge", true},    OptionRule{"--solve", true},
                                     OptionRule{"--unit", true},    OptionRule{"--up", true},
                                     OptionRule{"--threads", true}, OptionRule{"--report", true}};
constexpr std::size_t printedCauses = 5;
constexpr std::size_t printedAlike = 3;

std::string valuesText(const Explanation& one, Cause::Kind kind)
{
    std::string text;
    for (Eigen::Index k = 0; k < one.values.size(); ++k)
        text.append(k > 0 ? ", " : "")
            .append(one.values[k] > 0 ? "+" : "")
            .append(numberText(one.values[k], 3))
            .append(" +- ")
            .append(numberText(one.spreads[k], 2));
    return text.append(" ").append(unitOf(kind));
}

std::string alikeText(const Explanation& one, const std::vector<Cause>& causes)
{
    std::string text;
    for (std::size_t k = 0; k < std::min(one.alike.size(), printedAlike); ++k)
        text.append(k > 0 ? "; " : "").append(causes[one.alike[k]].name);
    if (one.alike.size() > printedAlike)
        text.append("; and ").append(std::to_string(one.alike.size() - printedAlike)).append(" more");
    return text;
}

void printExplanations(const Explanations& found, const std::vector<Cause>& causes)
{
    if (found.nothing()) {
        printResult("the scan shows " + numberText(100 * found.covered, 3) +
                    " % of the cover and lies on it: there is nothing to explain");
        return;
    }
    printResult("the scan shows " + numberText(100 * found.covered, 3) + " % of the cover and lies " +
                numberText(found.rms, 3) + " mm rms from it; all causes together leave " +
                numberText(found.noise, 3) + " mm");
    if (found.none > 0.5)
        printResult("no single cause explains that better than noise");
    for (std::size_t k = 0; k < std::min(printedCauses, found.ranked.size()); ++k) {
        const Explanation& one = found.ranked[k];
        const Cause& cause = causes[one.cause];
        printResult(std::to_string(k + 1) + ". " + cause.name + ": " + valuesText(one, cause.kind) + ", explains " +
                    numberText(100 * one.share, 3) + " %, probability " + numberText(one.probability, 2) +
                    (one.solved ? "" : " (not solved)"));
        if (!one.alike.empty())
            printResult("   not to be told apart from: " + alikeText(one, causes));
    }
    if (found.weak())
        printError("warning: even the likeliest cause explains only " +
                   numberText(100 * found.ranked.front().share, 2) +
                   " % of the deviation: there may be several, or others than these");
    if (found.leavesMore())
        printError(
            "warning: what the likeliest cause leaves is more than noise: something else may be wrong, too, and "
            "its amount may be off by more than is said");
}

Json listOf(const Eigen::VectorXd& values)
{
    return std::vector<double>(values.begin(), values.end());
}

Json explainReport(const Explanations& found, const std::vector<Cause>& causes)
{
    Json ranked = Json::array();
    for (const Explanation& one : found.ranked) {
        const Cause& cause = causes[one.cause];
        Json alike = Json::array();
        for (const std::size_t other : one.alike)
            alike.push_back(causes[other].name);
        ranked.push_back({{"name", cause.name},
                          {"kind", wordOf(cause.kind)},
                          {"element", number(cause.element)},
                          {"unit", unitOf(cause.kind)},
                          {"values", listOf(one.values)},
                          {"spreads", listOf(one.spreads)},
                          {"share", one.share},
                          {"log_evidence", one.evidence},
                          {"probability", one.probability},
                          {"solved", one.solved},
                          {"not_told_apart_from", std::move(alike)}});
    }
    return {{"deviation_rms_mm", found.rms},
            {"noise_mm", found.noise},
            {"covered", found.covered},
            {"probability_of_none", found.none},
            {"causes", std::move(ranked)}};
}

int explainFailed(const std::string& problem)
{
    printError("error: " + problem);
    return otherFailure;
}

} // namespace

int explain(std::span<const std::string> words)
{
    const Arguments arguments(words, explainRules);
    const QString path = arguments.onlyFile("DESIGN");
    expectDistinct({path, arguments.path("--scan"), arguments.path("--sound")}, {arguments.path("--report")});
    ExplainOrder order;
    order.edgeLength = arguments.number("--edge", 0, 0.1, 1000);
    order.solved = arguments.integer("--solve", order.solved, 0, 1000);
    order.threads = arguments.integer("--threads", 0, 0, 1024);
    Interrupt interrupt;
    const OpenedDesign opened = openedShown(path);
    OutputFiles(arguments, {"--report"}).protectInputs(path, opened.design);
    if (printErrors(opened.problems))
        return badInput;
    sayOfPulls(opened.design);
    const FitTarget scan = arguments.has("--scan")
                               ? targetIn(arguments.path("--scan"), arguments, interrupt.token())
                               : scanOf(opened, "--scan");
    FitTarget sound;
    if (arguments.has("--sound"))
        sound = targetIn(arguments.path("--sound"), arguments, interrupt.token());
    std::optional<CauseFinder> finder;
    Explanations found;
    {
        ProgressLine line("preparing");
        finder.emplace(
            SolveInput{opened.design, opened.files}, order,
            [&](double share) { line.say("derivatives, " + numberText(std::floor(100 * share), 3) + " %"); },
            interrupt.token());
        if (finder->nominal()) {
            line.say("causes");
            const auto solving = [&](double share) {
                line.say("causes, " + numberText(std::floor(100 * share), 3) + " %");
            };
            found = finder->explain(scan, sound, solving, interrupt.token());
        }
    }
    if (interrupt.token().stop_requested())
        return explainFailed("interrupted");
    if (!finder->nominal())
        return explainFailed(finder->problem().english());
    if (found.covered == 0)
        throw UsageError("the scan shows nothing of the cover: does it lie where the design is?");
    printExplanations(found, finder->causes());
    if (sound.empty() && found.mostlyUnexplained())
        printError("warning: most of the deviation has no cause of these kinds, so that the first need not be the "
                   "right one; give the scan of a sound piece with --sound");
    const QString report = arguments.path("--report");
    if (report.isEmpty())
        return done;
    interrupt.beginWriting();
    return writeAndSay(report, explainReport(found, finder->causes()).dump(1) + "\n") ? done : otherFailure;
}

} // namespace bolster::cli
