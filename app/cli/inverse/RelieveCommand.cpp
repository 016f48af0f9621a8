#include "DesignJson.h"
#include "DistinctFiles.h"
#include "FabricFields.h"
#include "FitTargetFiles.h"
#include "Interrupt.h"
#include "Output.h"
#include "OutputFiles.h"
#include "ProgressLine.h"
#include "Reliefs.h"
#include "Solving.h"
#include "Subcommands.h"

#include <QDir>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace bolster::cli {

const char* const relieveHelp = R"(Usage: bolster relieve DESIGN [options]

Where cloth is strained, or pressed together, by more than it may be: proposes
changes of the pattern, says what each gains and costs, and solves the best ones.
Edges are let out or taken in, made longer or shorter than what they are sewn to,
seams moved, corners let out, darts cut, seams made smooth or sharp.

Options:
  --limit PERCENT       of strain, instead of the limits of the fabrics
  --max-change MM       how far edges may move (6)
  --solve N             how many are solved, each at another place (5)
  --edge MM             edges of the triangles of predictions (the design's); longer
                        ones are faster and less sure
  --out-dir DIR         writes the solved ones as designs: relief-1.json ...; never
                        replaces a file
  --threads N           use N threads (0: as many as the machine has)
  --report FILE.json    all of them

Exit code:
  0  done, even when there is nothing to relieve
  1  an output cannot be written (the others are nevertheless) or is there
     already, interrupted, or no cover
  2  the design cannot be used, or wrong usage
)";

namespace {

using Json = nlohmann::ordered_json;

constexpr double farOff = 0.3;       // of the excess
constexpr double littleArea = 0.005; // of the cover

constexpr std::array relieveRules = {OptionRule{"--limit", true},   OptionRule{"--max-change", true},
                                     OptionRule{"--solve", true},   OptionRule{"--edge", true},
                                     OptionRule{"--out-dir", true}, OptionRule{"--threads", true},
                                     OptionRule{"--report", true}};

ReliefOrder reliefOrder(const Arguments& arguments)
{
    ReliefOrder order;
    if (arguments.has("--limit"))
        order.limit = arguments.number("--limit", 0, strainLimit.least, strainLimit.most);
    order.most = arguments.number("--max-change", order.most, 0.1, 100);
    order.solved = arguments.integer("--solve", order.solved, 1, 1000);
    order.edgeLength = arguments.number("--edge", 0, 0.1, 1000);
    order.threads = arguments.integer("--threads", 0, 0, 1024);
    return order;
}

std::string gainText(double gain)
{
    return percentText(std::abs(gain)) + (gain < 0 ? " more" : " less");
}

/// Of the cover, not of what is over the limit: all of next to nothing is next to nothing.
std::string areaText(const OverLimit& now, const ReliefGain& gain)
{
    return percentText((1 - gain.area) * now.area) + " of the cover is over the limit then";
}

/// ", 5.5 mm from "Scan" (now 6.1)" for each scan of the design.
std::string scansText(const ReliefList& list, const Relief& relief)
{
    std::string text;
    for (const ScanChange& scan : scanChanges(list, relief))
        text += ", " + numberText(scan.after, 3) + " mm from \"" + scan.name + "\" (now " +
                numberText(scan.before, 3) + ")";
    return text;
}

void printReliefs(const ReliefList& list)
{
    printResult(
        percentText(list.now.area) + " of the cover is over the limit" +
        (list.now.area > 0 && list.now.area < littleArea ? ", which is little: see whether it matters" : ""));
    if (list.reliefs.empty())
        printResult(list.now.area > 0 ? "no change relieves it" : "there is nothing to relieve");
    int place = 0;
    bool missed = false;
    for (const Relief& relief : list.reliefs) {
        if (!relief.solved)
            break;
        missed = missed || std::abs(relief.solved->energy - relief.predicted) > farOff;
        printResult(std::to_string(++place) + ". " + relief.text.english() + ": " +
                    gainText(relief.solved->energy) + " excess (" + gainText(relief.predicted) + " predicted), " +
                    areaText(list.now, *relief.solved) + "; sewn " + numberText(relief.sewn, 3) + " mm, outlines " +
                    numberText(relief.moved, 3) + " mm, the cover moves by " + numberText(relief.shape, 2) +
                    " mm (rms)" + scansText(list, relief));
    }
    if (missed)
        printError(
            "warning: solved covers are not as predicted (longer edges are less sure): better changes may be "
            "missing");
}

Json scansJson(const std::vector<SolveReport::ScanFit>& scans)
{
    Json all = Json::array();
    for (const SolveReport::ScanFit& scan : scans)
        all.push_back({{"name", scan.name}, {"element", number(scan.scan)}, {"rms_mm", scan.figures.rms}});
    return all;
}

Json reliefReport(const ReliefList& list)
{
    Json reliefs = Json::array();
    for (const Relief& relief : list.reliefs) {
        Json one{{"text", relief.text.english()},
                 {"kind", wordOf(relief.kind)},
                 {"element", number(relief.element)},
                 {"predicted_gain", relief.predicted}};
        one["solved_gain"] =
            relief.solved ? Json{{"energy", relief.solved->energy}, {"area", relief.solved->area}} : Json();
        one["sewn_mm"] = relief.sewn;
        one["moved_mm"] = relief.moved;
        one["shape_mm"] = relief.solved ? Json(relief.shape) : Json();
        one["scans"] = scansJson(relief.scans);
        reliefs.push_back(std::move(one));
    }
    return {{"over_limit", {{"energy", list.now.energy}, {"area", list.now.area}}},
            {"scans", scansJson(list.scans)},
            {"reliefs", std::move(reliefs)}};
}

QString reliefFile(const Arguments& arguments, int place)
{
    return arguments.path("--out-dir") + QString("/relief-%1.json").arg(place);
}

int relieveFailed(const std::string& problem)
{
    printError("error: " + problem);
    return otherFailure;
}

int writeReliefs(const Arguments& arguments, const Design& design, const ReliefList& list)
{
    std::vector<std::pair<QString, std::string>> files;
    if (const QString folder = arguments.path("--out-dir"); !folder.isEmpty()) {
        if (!QDir().mkpath(folder))
            return relieveFailed("the folder \"" + folder.toStdString() + "\" cannot be made");
        for (const Relief& relief : list.reliefs)
            if (relief.solved)
                files.emplace_back(reliefFile(arguments, static_cast<int>(files.size()) + 1),
                                   writeDesign(design.with(relief.edit)));
    }
    if (const QString report = arguments.path("--report"); !report.isEmpty())
        files.emplace_back(report, reliefReport(list).dump(1) + "\n");
    bool written = true; // all that can be: solving them has taken long
    for (const auto& [file, text] : files)
        written =
            (file == arguments.path("--report") ? writeAndSay(file, text) : writeNewAndSay(file, text)) && written;
    return written ? done : otherFailure;
}

} // namespace

int relieve(std::span<const std::string> words)
{
    const Arguments arguments(words, relieveRules);
    const QString path = arguments.onlyFile("DESIGN");
    expectDistinct({path}, {arguments.path("--report")});
    if (!canBeWritten({arguments.path("--report")}) ||
        !canBeMade(arguments.has("--out-dir") ? arguments.path("--out-dir") : QString()))
        return otherFailure;
    const ReliefOrder order = reliefOrder(arguments);
    for (int place = 1; arguments.has("--out-dir") && place <= order.solved; ++place)
        if (const QString file = reliefFile(arguments, place); isThere(file))
            return relieveFailed("\"" + file.toStdString() + "\" is there already; choose another folder");
    Interrupt interrupt;
    const OpenedDesign opened = openedShown(path);
    OutputFiles(arguments, {"--report"}).protectInputs(path, opened.design);
    if (printErrors(opened.problems))
        return badInput;
    sayOfPulls(opened.design);
    ReliefList list;
    {
        ProgressLine line("solving");
        list = proposeReliefs(
            {opened.design, opened.files}, order,
            [&](double share, const ReliefList*) {
                line.say("solving, " + numberText(std::floor(100 * share), 3) + " %");
            },
            interrupt.token());
    }
    if (interrupt.token().stop_requested())
        return relieveFailed("interrupted");
    if (!list.problem.empty())
        return relieveFailed(list.problem.english());
    printReliefs(list);
    interrupt.beginWriting();
    const int outcome = writeReliefs(arguments, opened.design, list);
    if (outcome == done && arguments.has("--out-dir"))
        sayOfFiles(opened.design, path, reliefFile(arguments, 1));
    return outcome;
}

} // namespace bolster::cli
