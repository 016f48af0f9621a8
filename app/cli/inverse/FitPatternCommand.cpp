#include "DesignJson.h"
#include "DistinctFiles.h"
#include "FabricFields.h"
#include "FitChange.h"
#include "FitTargetFiles.h"
#include "Interrupt.h"
#include "Output.h"
#include "OutputFiles.h"
#include "PatternFit.h"
#include "ProgressLine.h"
#include "Solving.h"
#include "Subcommands.h"

#include <QFileInfo>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace bolster::cli {

const char* const fitPatternHelp = R"(Usage: bolster fit-pattern DESIGN --to GOAL --out DESIGN.json [options]

Changes a pattern until the cover at rest is as it is wished.

Goals (--to may be given more than once):
  --to FILE             the cover lies on this mesh or these points (OBJ, PLY, STL ...)
  --to scan             the cover lies on the scan of the design
  --to strain           the strain is below the limits of the fabrics, and the cover
                        stays where it is
  --to smooth:PATCH     no cloth of that patch is pressed together, which makes folds
  --to seam:ID=CURVE    the seam with that number runs along that fixation curve, which
                        need not hold anything
  --to size:PATCH=90%   the patch has so much of its area

Options:
  --out FILE.json       the changed design; never replaced when it is there already
  --freedom WORDS       what may change: outlines (the usual), seams (where they end on
                        smooth edges), ease (how much the sides of seams differ), foam,
                        fixations (along the frame that they lie on, else anywhere),
                        pressure, stretch (stiffness and Poisson number of the fabrics),
                        with commas between them
  --lock WORDS          what stays: lengths (of seams against each other), straight
                        (edges), corners (their angles), patch:NAME; lengths,straight
                        without this. Grain, twins and notches always stay.
  --patch NAME          only these patches shall come nearer to the goal (may repeat)
  --area PATCH:X,Y,R    only this disc of a patch's plane (mm; may repeat)
  --max-change MM       how far a control point may move (20)
  --limit PERCENT       of strain, instead of the limits of the fabrics
  --unit mm|cm|m|in|ft  what the numbers in FILE are (what it says, or mm)
  --up y|z              what points up in FILE (what it says, or z)
  --threads N           use N threads (0: as many as the machine has)
  --report FILE.json    what was reached, and what has moved

Exit code:
  0  done
  1  an output cannot be written (the other one is nevertheless) or is there
     already, interrupted, or no cover
  2  the design or FILE cannot be used, or wrong usage
)";

namespace {

constexpr std::array fitRules = {
    OptionRule{"--to", true, true},   OptionRule{"--out", true},         OptionRule{"--freedom", true},
    OptionRule{"--lock", true},       OptionRule{"--patch", true, true}, OptionRule{"--area", true, true},
    OptionRule{"--max-change", true}, OptionRule{"--limit", true},       OptionRule{"--unit", true},
    OptionRule{"--up", true},         OptionRule{"--threads", true},     OptionRule{"--report", true}};

/// Words with commas between them. Throws UsageError for an empty one.
std::vector<std::string> wordsOf(const QString& text, const std::string& option)
{
    std::vector<std::string> words;
    for (const QString& word : text.split(','))
        words.push_back(word.toStdString());
    if (std::ranges::find(words, "") != words.end())
        throw UsageError(option + " takes words with commas between them");
    return words;
}

ElementId patchNamed(const Design& design, const std::string& name)
{
    ElementId found = noElement;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        if (patch.name == name)
            found = id;
    });
    if (found == noElement)
        throw UsageError("the design has no patch \"" + name + "\"");
    return found;
}

/// "Seat:120,40,60".
AreaSpot spotOf(const std::string& text, const Design& design)
{
    const std::size_t colon = text.rfind(':');
    const QStringList numbers =
        QString::fromStdString(text.substr(std::min(colon, text.size() - 1) + 1)).split(',');
    std::vector<double> values;
    bool known = colon != std::string::npos && numbers.size() == 3;
    for (const QString& number : numbers) {
        bool isNumber = false;
        values.push_back(number.toDouble(&isNumber));
        known = known && isNumber && std::abs(values.back()) <= 1e6;
    }
    if (!known || !(values[2] > 0))
        throw UsageError("--area takes PATCH:X,Y,R in mm, such as Seat:120,40,60, not \"" + text + "\"");
    const AreaSpot spot{patchNamed(design, text.substr(0, colon)), {values[0], values[1]}, values[2]};
    const Box2 box = design.find<Patch>(spot.patch)->outline.boundingBox();
    if (box.exteriorDistance(spot.at) > spot.radius)
        throw UsageError("--area " + text + ": nothing of the patch is there; it goes from " +
                         numberText(box.min().x(), 4) + "," + numberText(box.min().y(), 4) + " to " +
                         numberText(box.max().x(), 4) + "," + numberText(box.max().y(), 4) + " mm");
    return spot;
}

/// "seam:12=Ridge": what is before the sign, and after it. Throws UsageError without the sign.
std::pair<std::string, std::string> sidesOf(const std::string& goal, const std::string& text)
{
    const std::size_t sign = text.rfind('=');
    if (sign == std::string::npos)
        throw UsageError("\"--to " + goal + "\": a = is missing");
    return {text.substr(0, sign), text.substr(sign + 1)};
}

SeamGoal seamGoal(const std::string& goal, const std::string& text, const Design& design)
{
    const std::pair<std::string, std::string> sides = sidesOf(goal, text);
    const std::string &seam = sides.first, &name = sides.second;
    bool known = false;
    const auto id = static_cast<ElementId>(QString::fromStdString(seam).toUInt(&known));
    if (!known || !design.find<Seam>(id))
        throw UsageError("--to " + goal + ": the design has no seam with the number \"" + seam + "\"");
    std::optional<SeamGoal> found;
    design.each<FixationCurve>([&](ElementId, const FixationCurve& curve) {
        if (curve.name == name)
            found = SeamGoal{id, curve.curve};
    });
    if (!found)
        throw UsageError("--to " + goal + ": the design has no fixation curve \"" + name + "\"");
    return *found;
}

SizeGoal sizeGoal(const std::string& goal, const std::string& text, const Design& design)
{
    const auto [name, size] = sidesOf(goal, text);
    bool known = false;
    QString percent = QString::fromStdString(size);
    if (percent.endsWith('%'))
        percent.chop(1);
    const double share = percent.toDouble(&known) / 100;
    if (!known || !(share >= 0.1 && share <= 10))
        throw UsageError("--to " + goal + ": 10 % to 1000 % are expected behind the =");
    return {patchNamed(design, name), share};
}

/// Goals that need no form; false when it is none of them.
bool addWish(const std::string& goal, const Design& design, FitGoals& goals)
{
    const std::size_t colon = goal.find(':');
    const std::string kind = goal.substr(0, colon);
    if (colon == std::string::npos || (kind != "smooth" && kind != "seam" && kind != "size"))
        return false;
    const std::string text = goal.substr(colon + 1);
    if (kind == "smooth") {
        goals.smooth.insert(patchNamed(design, text));
    } else if (kind == "seam") {
        const SeamGoal more = seamGoal(goal, text, design);
        if (std::ranges::count(goals.seams, more.seam, &SeamGoal::seam) > 0)
            throw UsageError("--to " + goal + ": that seam runs along another curve already");
        goals.seams.push_back(more);
    } else {
        const SizeGoal more = sizeGoal(goal, text, design);
        if (std::ranges::count(goals.sizes, more.patch, &SizeGoal::patch) > 0)
            throw UsageError("--to " + goal + ": that patch has been given a size already");
        goals.sizes.push_back(more);
    }
    return true;
}

struct Asked {
    FitOrder order;
    std::set<ElementId> held; // patches whose outlines stay
};

void readLocks(const Arguments& arguments, const Design& design, Asked& asked)
{
    if (!arguments.has("--lock"))
        return;
    asked.order.locks.lengths = asked.order.locks.straight = false;
    const std::vector<std::string> words = wordsOf(arguments.path("--lock"), "--lock");
    const auto isAsked = [&](const char* word) { return std::ranges::find(words, word) != words.end(); };
    if (isAsked("none") && (isAsked("lengths") || isAsked("straight") || isAsked("corners")))
        throw UsageError("--lock takes none without lengths, straight and corners");
    for (const std::string& word : words) {
        if (word == "lengths")
            asked.order.locks.lengths = true;
        else if (word == "straight")
            asked.order.locks.straight = true;
        else if (word == "corners")
            asked.order.locks.corners = true;
        else if (word.starts_with("patch:"))
            asked.held.insert(patchNamed(design, word.substr(6)));
        else if (word != "grain" && word != "symmetry" && word != "notches" && word != "none")
            throw UsageError("--lock knows lengths, straight, corners, grain, symmetry, notches, none and "
                             "patch:NAME, not \"" +
                             word + "\"");
    }
}

void readFreedoms(const Arguments& arguments, const OpenedDesign& opened, Asked& asked)
{
    const Design& design = opened.design;
    const QString text = arguments.has("--freedom") ? arguments.path("--freedom") : "outlines";
    bool lockedAll = false; // if nothing remains
    const auto add = [&](std::vector<Freedom> more) {
        for (Freedom& freedom : more)
            if (asked.held.contains(freedom.element))
                lockedAll = true;
            else
                asked.order.freedoms.push_back(std::move(freedom));
    };
    const std::vector<std::string> words = wordsOf(text, "--freedom");
    constexpr std::array known{"outlines", "seams", "ease", "foam", "fixations", "pressure", "stretch"};
    for (const std::string& word : words)
        if (std::ranges::find(known, word) == known.end())
            throw UsageError(
                "--freedom knows outlines, seams, ease, foam, fixations, pressure and stretch, not \"" + word +
                "\"");
    // Each once, and always in the same order: how they are written must not matter.
    const auto takes = [&](const char* word) { return std::ranges::find(words, word) != words.end(); };
    if (takes("outlines"))
        add(outlineFreedoms(design));
    if (takes("foam"))
        add(foamFreedoms(design));
    if (takes("fixations"))
        add(fixationFreedoms(design, opened.files));
    if (takes("pressure"))
        add(pressureFreedoms(design));
    if (takes("stretch"))
        add(stretchFreedoms(design));
    if (takes("seams"))
        add(seamEndFreedoms(design));
    asked.order.locks.ease = !takes("ease");
    if (asked.order.freedoms.empty() && !asked.order.locks.ease)
        throw UsageError("--freedom ease: sides of seams come to differ when outlines may change, too: "
                         "--freedom outlines,ease");
    if (design.count<Patch>() == 0)
        throw UsageError("the design has no patch: there is no pattern to fit");
    if (asked.order.freedoms.empty())
        throw UsageError(lockedAll ? "--lock patch: holds all of what --freedom names"
                                   : "the design has nothing of what --freedom names");
}

std::string asText(const Message& problem)
{
    return problem.empty() ? "interrupted" : problem.english();
}

Asked askedOf(const Arguments& arguments, const OpenedDesign& opened, const std::stop_token& stop)
{
    Asked asked;
    readLocks(arguments, opened.design, asked);
    readFreedoms(arguments, opened, asked);
    FitGoals& goals = asked.order.goals;
    for (const std::string& name : arguments.values("--patch"))
        goals.area.patches.insert(patchNamed(opened.design, name));
    for (const std::string& spot : arguments.values("--area"))
        goals.area.spots.push_back(spotOf(spot, opened.design));
    for (const std::string& goal : arguments.values("--to")) {
        if (goal == "strain")
            goals.strain = true;
        else if (addWish(goal, opened.design, goals))
            continue;
        else if (!goals.target.empty())
            throw UsageError("the cover can lie on one form alone");
        else
            goals.target = goal == "scan" ? scanOf(opened, "--to") : targetIn(exactText(goal), arguments, stop);
    }
    if (!goals.any())
        throw UsageError("to what? --to FILE, scan, strain, smooth:, seam: or size:");
    if (arguments.has("--limit"))
        goals.limit = arguments.number("--limit", 0, strainLimit.least, strainLimit.most);
    goals.keepShape = goals.target.empty() ? FitGoals::lightly : 0;
    asked.order.mostChange =
        arguments.number("--max-change", asked.order.mostChange, FitOrder::leastChange, FitOrder::farthestChange);
    asked.order.threads = arguments.integer("--threads", 0, 0, 1024);
    return asked;
}

using Json = nlohmann::ordered_json;

/// Of what was not asked for there are none.
Json figuresJson(const FitGoals& goals, const FitFigures& figures)
{
    Json json = Json::object();
    if (!goals.target.empty()) {
        json["distance_mm"] = {{"rms", figures.distanceRms}, {"p95", figures.distanceP95}};
        json["covered"] = figures.covered;
    }
    json["over_limit"] = figures.overLimit;
    json["strain_rms"] = figures.strainRms;
    if (!goals.smooth.empty())
        json["pressed"] = figures.pressed;
    if (!goals.seams.empty())
        json["seam_distance_mm"] = figures.seamRms;
    if (!goals.sizes.empty())
        json["size_off"] = figures.sizeMost;
    json["shape_change_mm"] = figures.shapeRms;
    json["seam_difference_mm"] = figures.sewnMost;
    return json;
}

Json reportOf(const FitOrder& order, const FitResult& result)
{
    const auto asJson = [&](const FitFigures& figures) { return figuresJson(order.goals, figures); };
    Json rounds = Json::array(), moved = Json::array();
    for (const FitRound& round : result.rounds)
        rounds.push_back({{"edge_mm", round.edgeLength},
                          {"largest_change_mm", round.largestChange},
                          {"reached", asJson(round.figures)}});
    for (std::size_t k = 0; k < order.freedoms.size(); ++k)
        if (const double value = result.values[static_cast<Eigen::Index>(k)]; value != 0)
            moved.push_back({{"name", order.freedoms[k].name},
                             {"element", number(order.freedoms[k].element)},
                             {"change", value}});
    return {{"before", asJson(result.before)},
            {"after", asJson(result.after)},
            {"largest_change_mm", largestChange(order.freedoms, result.values)},
            {"jumped", result.jumped},
            {"rounds", std::move(rounds)},
            {"changes", std::move(moved)},
            {"without_effect", result.idle}};
}

std::string overLimitText(const FitGoals& goals, const FitFigures& figures)
{
    return percentText(figures.overLimit) + " of the " + (goals.area.isAll() || !goals.strain ? "cover" : "area");
}

std::string reachedText(const FitGoals& goals, const FitFigures& figures)
{
    std::string text;
    if (!goals.target.empty())
        text += numberText(figures.distanceRms, 3) + " mm rms from the form, " +
                numberText(figures.distanceP95, 3) + " mm within 95 %; ";
    if (!goals.smooth.empty())
        text.append(percentText(figures.pressed)).append(" pressed together; ");
    if (!goals.seams.empty())
        text.append(numberText(figures.seamRms, 3)).append(" mm rms from the curves; ");
    if (!goals.sizes.empty())
        text.append(percentText(figures.sizeMost)).append(" off the area that is wanted; ");
    return text + overLimitText(goals, figures) + " over the limit" + (goals.limit ? "" : "s of the fabrics");
}

std::string missText(const MissedGoal& miss)
{
    using enum MissedGoal::Kind;
    const bool isLength = miss.kind == Form || miss.kind == Seams;
    const std::string before = isLength ? numberText(miss.before, 3) + " mm rms" : percentText(miss.before),
                      after = isLength ? numberText(miss.after, 3) + " mm" : percentText(miss.after);
    const char* goal = miss.kind == Form     ? "the form"
                       : miss.kind == Strain ? "the limit of strain"
                       : miss.kind == Smooth ? "the patches without folds"
                       : miss.kind == Seams  ? "the curves"
                                             : "the area that is wanted";
    return std::string("it comes hardly nearer to ") + goal + ": " + before + " before, " + after + " now";
}

/// What the change costs, or does not bring.
void printMisses(const FitOrder& order, const FitResult& result)
{
    constexpr double littleCovered = 0.2; // share of the cover
    const FitFigures &before = result.before, &after = result.after;
    if (!order.goals.target.empty() && before.covered < littleCovered)
        printError("warning: only " + percentText(before.covered, 2) +
                   " of the cover has the form beside it: the distances are of that alone");
    if (!result.values.isZero())
        for (const MissedGoal& miss : missedGoals(order.goals.strain, before, after))
            printError("warning: " + missText(miss) +
                       "; let something else change, or more of it (--freedom, --max-change)");
    if (strainsMore(before, after))
        printError("warning: more of the cloth is strained over its limits: " + overLimitText(order.goals, before) +
                   " before, " + overLimitText(order.goals, after) +
                   " now; --to strain besides the other goals, or a smaller --max-change keeps it down");
}

void printOutcome(const FitOrder& order, const FitResult& result)
{
    printResult("before: " + reachedText(order.goals, result.before));
    if (result.status == FitResult::Status::NothingToDo && result.rounds.empty()) {
        printError("warning: nothing is over the limits; the design is written as it was");
        return;
    }
    printResult("after:  " + reachedText(order.goals, result.after));
    const double moved = largestChange(order.freedoms, result.values); // 0 when foam, pressure ... change alone
    printResult((moved > 0 ? "points have moved by " + numberText(moved, 3) + " mm at most, " : "") +
                "the cover has moved by " + numberText(result.after.shapeRms, 3) +
                " mm rms; sides of seams are off what is wanted by " + numberText(result.after.sewnMost, 2) +
                " mm at most");
    for (const Message& note : result.notes)
        printError("warning: " + note.english());
    printMisses(order, result);
    if (missesLengths(order.locks, result.before, result.after))
        printError("warning: the lengths of seams did not stay: sides differ by up to " +
                   numberText(result.after.sewnMost, 2) +
                   " mm more than is wanted. Let more change, or the ease, "
                   "too (--freedom outlines,ease)");
    if (mendsLengths(order.locks, result.before, result.after))
        printError("note: sides of seams that were up to " + numberText(result.before.sewnMost, 2) +
                   " mm off their ease come nearer to it: " + numberText(result.after.sewnMost, 2) +
                   " mm. To keep a difference, make it the seam's ease first");
    if (!result.idle.empty())
        printError("warning: " + std::to_string(result.idle.size()) + " of " +
                   std::to_string(order.freedoms.size()) +
                   " things that may change do nothing to the goal, such as " + result.idle.front());
    if (result.jumped)
        printError("warning: a fold came or went on the way, so the result is less sure: look at the cover");
    if (result.status == FitResult::Status::NothingToDo)
        printError("warning: no change makes it better; the design is written as it was");
}

} // namespace

int fitPattern(std::span<const std::string> words)
{
    const Arguments arguments(words, fitRules);
    const QString path = arguments.onlyFile("DESIGN");
    const QString out = arguments.path("--out"), report = arguments.path("--report");
    if (out.isEmpty())
        throw UsageError("where to? --out DESIGN.json");
    if (isThere(out)) {
        printError("error: \"" + out.toStdString() + "\" is there already; choose another name");
        return otherFailure;
    }
    QStringList inputs{path};
    for (const std::string& goal : arguments.values("--to"))
        inputs << exactText(goal);
    expectDistinct(inputs, {out, report});
    if (!canBeWritten({out, report}))
        return otherFailure;
    Interrupt interrupt;
    const OpenedDesign opened = openedShown(path);
    OutputFiles(arguments, {"--report"}).protectInputs(path, opened.design);
    if (printErrors(opened.problems))
        return badInput;
    sayOfPulls(opened.design);
    const Asked asked = askedOf(arguments, opened, interrupt.token());
    FitResult result;
    {
        ProgressLine line("preparing");
        result = bolster::fitPattern(
            {opened.design, opened.files}, asked.order,
            [&](double share, const FitRound& round) {
                line.say(numberText(std::floor(100 * share), 3) + " %, " +
                         reachedText(asked.order.goals, round.figures));
            },
            interrupt.token());
    }
    if (result.status == FitResult::Status::Cancelled || result.status == FitResult::Status::Failed) {
        printError("error: " + asText(result.reason));
        return otherFailure;
    }
    printOutcome(asked.order, result);
    interrupt.beginWriting();
    if (!writeWithReport(out, writeDesign(result.design), report, reportOf(asked.order, result).dump(1) + "\n"))
        return otherFailure;
    sayOfFiles(result.design, path, out);
    return done;
}

} // namespace bolster::cli
