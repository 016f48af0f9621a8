// Splitting patches along lines and merging them along seams; and all edits of patches by chance.
#include "ArcLength.h"
#include "CopyPaste.h"
#include "CornerEdits.h"
#include "DesignCheck.h"
#include "ElementEdits.h"
#include "FollowEdits.h"
#include "LayoutEdits.h"
#include "MeasurementEdits.h"
#include "OutlineCrossings.h"
#include "OutlineEdits.h"
#include "PatchEdits.h"
#include "PatchMerge.h"
#include "PatchShapeEdits.h"
#include "PatchSplit.h"

#include "Random.h"
#include "TestData.h"
#include "TestPaths.h"
#include "Twins.h"

#include <fstream>
#include <iterator>

namespace bolster::splitting { // names that other tests have, too
namespace {

using namespace edits;

constexpr const char* sewnPatches = R"({"format": "bolster-design", "version": 1, "unit": "mm", "elements": [
  {"id": 1, "kind": "fabric", "name": "Leather"},
  {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1, "position": [10, 20],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[500,0],[500,400],[0,400]]}},
  {"id": 3, "kind": "patch", "name": "Side", "fabric": 1, "position": [600, 100], "rotation": 90,
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[400,0],[400,120],[0,120]]}},
  {"id": 4, "kind": "seam", "a": {"patch": 2, "from": 1, "to": 2}, "b": {"patch": 3, "from": 0, "to": 1}},
  {"id": 5, "kind": "fixation_curve", "name": "Rail",
   "curve": {"degree": 1, "closed": false, "points": [[0,0,0],[500,0,0]]}},
  {"id": 6, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 5},
  {"id": 7, "kind": "fancy_seam", "name": "Pipe", "patch": 2,
   "curve": {"degree": 1, "closed": false, "points": [[100,50],[100,350]]}},
  {"id": 8, "kind": "handle_curve", "name": "Lumbar", "patch": 2,
   "curve": {"degree": 1, "closed": false, "points": [[100,300],[400,300]]},
   "target": {"degree": 1, "closed": false, "points": [[100,300,40],[400,300,40]]}}]})";

constexpr ElementId seat{2}, side{3}, seam{4}, rail{5}, fixation{6}, pipe{7}, lumbar{8};

int errors(const Design& design)
{
    int count = 0;
    for (const Problem& problem : checkDesign(design))
        count += problem.severity == Severity::Error;
    return count;
}

double length(const Design& design, const Stretch& stretch)
{
    const BSpline2& outline = design.find<Patch>(stretch.patch)->outline;
    return ArcLength2(outline).between(
        stretch.from, unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd()));
}

Vec2 layoutAt(const Design& design, ElementId id, double t)
{
    const Patch& patch = *design.find<Patch>(id);
    return toLayout(patch, patch.outline.at(t));
}

double area(const Design& design)
{
    double sum = 0;
    design.each<Patch>([&](ElementId, const Patch& patch) { sum += std::abs(patch.outline.signedArea()); });
    return sum;
}

std::vector<Seam> seamsOf(const Design& design, ElementId a, ElementId b)
{
    std::vector<Seam> found;
    design.each<Seam>([&](ElementId, const Seam& s) {
        if ((s.a.patch == a && s.b.patch == b) || (s.a.patch == b && s.b.patch == a))
            found.push_back(s);
    });
    return found;
}

class SplitMerge : public testing::Test {
protected:
    const Design design = test::soundDesign(sewnPatches);

    Design done(const Design& before, const Outcome& outcome)
    {
        EXPECT_TRUE(outcome.problem.empty()) << outcome.problem.english();
        EXPECT_FALSE(outcome.edit.empty());
        const Design after = before.with(outcome.edit);
        EXPECT_EQ(after.with(outcome.edit.inverse()), before);
        EXPECT_EQ(readDesign(writeDesign(after)).design, after);
        EXPECT_EQ(errors(after), errors(before));
        for (const Problem& problem : checkDesign(after))
            EXPECT_EQ(problem.severity, Severity::Warning) << problem.english();
        return after;
    }
    Outcome split(const std::vector<Vec2>& line) const { return splitPatch(design, seat, line); }
    ElementId other(const Design& after) const
    {
        ElementId id{};
        after.each<Patch>([&](ElementId one, const Patch&) { id = one == seat || one == side ? id : one; });
        return id;
    }
    /// That sews the seat to what was cut off.
    ElementId cutSeam(const Design& after) const
    {
        ElementId found{};
        after.each<Seam>([&](ElementId id, const Seam& s) {
            if (std::set{s.a.patch, s.b.patch} == std::set{seat, other(after)})
                found = id;
        });
        return found;
    }
    static std::vector<Seam> seamsBetween(const Design& d, ElementId a, ElementId b) { return seamsOf(d, a, b); }
};

TEST_F(SplitMerge, SplitsAcrossASeamAndDividesIt)
{
    const Outcome outcome = split({{-100, 120}, {900, 120}}); // at y = 100 of the seat, from edge to edge
    const Design after = done(design, outcome);
    EXPECT_TRUE(outcome.dropped.empty());
    EXPECT_EQ(outcome.edit.verb.english(), "Split Seat");
    const ElementId lower = other(after);
    ASSERT_TRUE(after.find<Patch>(lower));
    EXPECT_EQ(after.find<Patch>(lower)->name, "Seat 2");
    EXPECT_NEAR(after.find<Patch>(seat)->outline.signedArea(), 500 * 300, 1e-6);
    EXPECT_NEAR(after.find<Patch>(lower)->outline.signedArea(), 500 * 100, 1e-6);

    const std::vector<Seam> cut = seamsBetween(after, seat, lower);
    ASSERT_EQ(cut.size(), 1u);
    EXPECT_EQ(cut[0].continuity, Continuity::C1);
    EXPECT_NEAR(length(after, cut[0].a), 500, 1e-6);
    EXPECT_LT(
        (layoutAt(after, cut[0].a.patch, cut[0].a.from) - layoutAt(after, cut[0].b.patch, cut[0].b.to)).norm(),
        1e-9);

    const std::vector<Seam> upperSide = seamsBetween(after, seat, side),
                            lowerSide = seamsBetween(after, lower, side);
    ASSERT_EQ(upperSide.size(), 1u);
    ASSERT_EQ(lowerSide.size(), 1u);
    EXPECT_NEAR(length(after, upperSide[0].a), 300, 1e-6);
    EXPECT_NEAR(length(after, upperSide[0].b), 300, 1e-6);
    EXPECT_NEAR(length(after, lowerSide[0].b), 100, 1e-6);
    EXPECT_NEAR(lowerSide[0].b.from, 0.75, 1e-9) << "the side is walked backwards";
    EXPECT_EQ(after.find<FixationSeam>(fixation)->stretch.patch, lower);
    EXPECT_EQ(after.find<HandleCurve>(lumbar)->patch, seat) << "it lies above the cut";
    int pipes = 0;
    after.each<FancySeam>([&](ElementId, const FancySeam&) { ++pipes; });
    EXPECT_EQ(pipes, 2) << "it crosses the cut";
}

TEST_F(SplitMerge, DividesFixationsAndHandles)
{
    const Design after = done(design, split({{210, 0}, {210, 500}})); // at x = 200 of the seat
    const ElementId left = other(after);
    std::map<ElementId, std::pair<double, double>> ranges;
    after.each<FixationSeam>([&](ElementId, const FixationSeam& held) {
        ASSERT_TRUE(held.curveRange);
        ranges[held.stretch.patch] = *held.curveRange;
        EXPECT_NEAR(length(after, held.stretch), held.stretch.patch == left ? 200 : 300, 1e-6);
    });
    EXPECT_NEAR(ranges[left].second, 0.4, 1e-9);
    EXPECT_NEAR(ranges[seat].first, 0.4, 1e-9);
    std::map<ElementId, const HandleCurve*> handles;
    after.each<HandleCurve>([&](ElementId, const HandleCurve& handle) { handles[handle.patch] = &handle; });
    ASSERT_EQ(handles.size(), 2u);
    EXPECT_LT((handles[left]->curve.points().back() - Vec2(200, 300)).norm(), 1e-6);
    EXPECT_LT((handles[left]->target.points().back() - Vec3(200, 300, 40)).norm(), 1e-6);
    EXPECT_LT((handles[seat]->target.points().front() - Vec3(200, 300, 40)).norm(), 1e-6);
}

/// What the parts cover of the handle, and that they lie where it lay.
void expectPartsOf(const Design& after, const HandleCurve& whole, int count)
{
    double length = 0, onTarget = 0;
    after.each<HandleCurve>([&](ElementId, const HandleCurve& part) {
        const Patch* patch = after.find<Patch>(part.patch);
        ASSERT_TRUE(patch);
        const ArcLength2 here(part.curve);
        length += here.total();
        onTarget += ArcLength3(part.target).total();
        for (int k = 1; k < 8; ++k) {
            const Vec2 at = part.curve.at(here.parameterAt(here.total() * k / 8));
            EXPECT_LT(whole.curve.closest(at).distance, 1e-6);
            EXPECT_TRUE(isInside(patch->outline, at));
        }
    });
    EXPECT_EQ(after.count<HandleCurve>(), count);
    EXPECT_NEAR(length, ArcLength2(whole.curve).total(), 1e-6);
    EXPECT_NEAR(onTarget, ArcLength3(whole.target).total(), 1e-6);
}

TEST_F(SplitMerge, DividesHandlesWhereverTheyCrossTheCut)
{
    HandleCurve zigzag = *design.find<HandleCurve>(lumbar);
    zigzag.curve = BSpline2(1, false, {{100, 150}, {200, 350}, {300, 150}, {400, 350}});
    zigzag.target = BSpline3(1, false, {{0, 0, 0}, {30, 40, 0}, {60, 80, 0}, {90, 120, 0}});
    const Design start = design.with({{}, {{lumbar, nullptr, makeElement(zigzag)}}});
    const Outcome outcome = splitPatch(start, seat, {{-100, 270}, {900, 270}}); // at y = 250 of the seat
    EXPECT_TRUE(outcome.dropped.empty());
    const Design cut = start.with(outcome.edit);
    expectPartsOf(cut, zigzag, 4);
    const Design whole = cut.with(mergePatches(cut, cutSeam(cut)).edit);
    ASSERT_EQ(whole.count<HandleCurve>(), 1) << "merged again it is one";
    EXPECT_EQ(whole.find<HandleCurve>(lumbar)->curve.pointCount(), zigzag.curve.pointCount());
    EXPECT_EQ(errors(whole), errors(start));
}

TEST_F(SplitMerge, DividesRingsThatCrossTheCut)
{
    HandleCurve ring = *design.find<HandleCurve>(lumbar);
    ring.curve = BSpline2(1, true, {{100, 150}, {400, 150}, {400, 350}, {100, 350}});
    ring.target = BSpline3(1, true, {{0, 0, 0}, {30, 0, 0}, {30, 20, 0}, {0, 20, 0}});
    const Design start = design.with({{}, {{lumbar, nullptr, makeElement(ring)}}});
    for (const double x : {160.0, 330.0}) {
        const Outcome outcome = splitPatch(start, seat, {{x, 0}, {x, 500}});
        EXPECT_TRUE(outcome.dropped.empty());
        const Design cut = start.with(outcome.edit);
        expectPartsOf(cut, ring, 2);
        const Design whole = cut.with(mergePatches(cut, cutSeam(cut)).edit);
        ASSERT_EQ(whole.count<HandleCurve>(), 1);
        const auto* handle = whole.find<HandleCurve>(lumbar);
        EXPECT_TRUE(handle && handle->curve.closed() && handle->target.closed());
        EXPECT_NEAR(ArcLength2(handle->curve).total(), ArcLength2(ring.curve).total(), 1e-6);
        EXPECT_NEAR(ArcLength3(handle->target).total(), ArcLength3(ring.target).total(), 1e-6);
    }
}

TEST_F(SplitMerge, StubsOfHandlesThatAreTooShortGo)
{
    const Outcome outcome = split({{113, 0}, {113, 500}}); // at x = 103 of the seat: 3 mm beyond its start
    const Design after = done(design, outcome);
    EXPECT_EQ(after.count<HandleCurve>(), 1);
    const auto* handle = after.find<HandleCurve>(lumbar);
    ASSERT_TRUE(handle);
    EXPECT_EQ(handle->patch, seat);
    EXPECT_NEAR(handle->curve.points().front().x(), 103, 1e-6);
    EXPECT_NEAR(handle->target.points().front().x(), 103, 1e-6);
    EXPECT_EQ(handle->name, "Lumbar");
    EXPECT_EQ(outcome.edit.note.english(),
              "Parts of Lumbar that are shorter than a mesh edge have gone with the cut.");
    EXPECT_TRUE(outcome.dropped.empty());
}

TEST_F(SplitMerge, SplitsAlongBentLinesAndFromCornerToCorner)
{
    const Design bent = done(design, split({{10, 220}, {250, 300}, {510, 220}}));
    EXPECT_EQ(seamsBetween(bent, seat, other(bent)).size(), 1u);
    EXPECT_NEAR(area(bent), area(design), 1e-6);
    const Design diagonal = done(design, split({{10, 20}, {510, 420}}));
    EXPECT_EQ(diagonal.find<Patch>(seat)->outline.pointCount(), 3);
    EXPECT_EQ(diagonal.find<Patch>(other(diagonal))->outline.pointCount(), 3);
}

TEST_F(SplitMerge, SplitsSplines)
{
    std::vector<Vec2> round;
    for (int i = 0; i < 10; ++i)
        round.emplace_back(200 * std::cos(0.2 * M_PI * i), 150 * std::sin(0.2 * M_PI * i));
    for (const int degree : {2, 3}) {
        const BSpline2 outline(degree, true, round);
        const Design smooth = Design().with(addPatch(Design(), outline, "Round"));
        const ElementId id = smooth.elements().rbegin()->first;
        const Design after = done(smooth, splitPatch(smooth, id, {{-300, 37}, {20, 20}, {300, -11}}));
        EXPECT_NEAR(area(after), area(smooth), 1e-4);
        const BSpline2& piece = after.find<Patch>(id)->outline;
        const Patch& before = *smooth.find<Patch>(id);
        for (double t = piece.domainStart(); t < piece.domainEnd(); t += 0.1) {
            const Vec2 p = toLayout(before, piece.at(t));
            const bool onOld = outline.closest(p).distance < 1e-6;
            const bool onCut = std::abs(p.y()) < 40;
            EXPECT_TRUE(onOld || onCut) << p.transpose();
        }

        ElementId cut{};
        after.each<Seam>([&](ElementId one, const Seam&) { cut = one; });
        const Design whole = done(after, mergePatches(after, cut));
        EXPECT_EQ(whole.elements().size(), smooth.elements().size());
        EXPECT_NEAR(area(whole), area(smooth), 1e-4);
        for (int k = 0; k < 50; ++k) {
            const Vec2 p = outline.at(0.2 * k) - before.position;
            EXPECT_LT(whole.find<Patch>(id)->outline.closest(p).distance, 1e-5);
        }
        EXPECT_EQ(whole.find<Patch>(id)->outline.corners().size(), 0u) << "as smooth as it was";
    }
}

TEST_F(SplitMerge, RefusesLinesThatDoNotCut)
{
    const auto why = [&](const std::vector<Vec2>& line) {
        const Outcome outcome = split(line);
        EXPECT_TRUE(outcome.edit.empty());
        return outcome.problem.english();
    };
    EXPECT_EQ(why({{-100, 120}, {300, 120}}),
              "The line must cross the outline of Seat exactly twice, not 1 times.");
    EXPECT_EQ(why({{100, 120}, {300, 120}}), "The line must cross the outline of Seat exactly twice, not 0 times.");
    EXPECT_EQ(why({{-100, 120}, {900, 120}, {900, 200}, {-100, 200}}),
              "The line must cross the outline of Seat exactly twice, not 4 times.");
    EXPECT_EQ(why({{-100, 120}, {400, 120}, {200, 300}, {200, 60}, {900, 60}}),
              "A piece of Seat would cross itself or be too narrow: draw another line.");
    EXPECT_EQ(why({{10, 20}, {510, 20}}), "The line must run inside Seat.");
    EXPECT_FALSE(why({{10, 20}}).empty());
    EXPECT_FALSE(splitPatch(design, rail, {{0, 0}, {1, 1}}).problem.empty());
    EXPECT_FALSE(split({{std::nan(""), 0}, {1, 1}}).problem.empty());
}

TEST_F(SplitMerge, MergesAlongASeam)
{
    const Design noted = design.with(changeNote(design, side, "ask Anna"));
    const Outcome outcome = mergePatches(noted, seam);
    const Design after = done(noted, outcome);
    EXPECT_EQ(after.find<Patch>(seat)->note, "ask Anna") << "of neither is it lost";
    EXPECT_TRUE(outcome.dropped.empty());
    EXPECT_EQ(outcome.edit.verb.english(), "Merge Seat and Side");
    EXPECT_FALSE(after.element(side));
    EXPECT_FALSE(after.element(seam));
    const Patch& merged = *after.find<Patch>(seat);
    EXPECT_EQ(merged.outline.pointCount(), 6)
        << "the sides have their parameters at another pace: joints stay points";
    EXPECT_NEAR(merged.outline.signedArea(), 620 * 400, 1e-6);
    EXPECT_NEAR(merged.outline.boundingBox().max().x(), 620, 1e-6);
    EXPECT_NEAR(length(after, after.find<FixationSeam>(fixation)->stretch), 500, 1e-6) << "it keeps its place";
    EXPECT_LT((merged.outline.at(after.find<FixationSeam>(fixation)->stretch.to) - Vec2(500, 0)).norm(), 1e-6);
}

TEST_F(SplitMerge, MeasurementsStayWhereTheyAre)
{
    const PatchPoint from{seat, {50, 200}}, to{seat, {450, 200}}, over{side, {100, 60}};
    Design measured = design.with(addMeasurement(design, from, to, "Width"));
    const ElementId width = design.nextId();
    measured = measured.with(addMeasurement(measured, to, over, "Over the edge"));
    const ElementId edge = ElementId{static_cast<std::int32_t>(width) + 1};
    measured = measured.with(addMeasurement(measured, {seat, {0, 0}}, {seat, {500, 0}}, "Front edge"));
    const ElementId corners = ElementId{static_cast<std::int32_t>(width) + 2};
    const auto places = [](const Design& in, ElementId id) {
        const Measurement& m = *in.find<Measurement>(id);
        return std::pair(toLayout(*in.find<Patch>(m.from.patch), m.from.position),
                         toLayout(*in.find<Patch>(m.to.patch), m.to.position));
    };
    const auto stay = [&](const Design& after, double tolerance) {
        for (const ElementId id : {width, edge, corners}) {
            EXPECT_LT((places(after, id).first - places(measured, id).first).norm(), tolerance);
            EXPECT_LT((places(after, id).second - places(measured, id).second).norm(), tolerance);
        }
    };
    for (const double x : {180.0, 340.0}) { // the piece that gets another id is on the left, then on the right
        const Design halves = done(measured, splitPatch(measured, seat, {{x, 0}, {x, 900}}));
        for (const ElementId id : {width, corners}) {
            const Measurement& across = *halves.find<Measurement>(id);
            EXPECT_NE(across.from.patch, across.to.patch) << "each end goes with its half";
        }
        stay(halves, 1e-9);
    }

    const Design merged = done(measured, mergePatches(measured, seam));
    const Measurement& inOne = *merged.find<Measurement>(edge);
    EXPECT_EQ(inOne.from.patch, seat);
    EXPECT_EQ(inOne.to.patch, seat);
    EXPECT_LT((inOne.to.position - Vec2(560, 300)).norm(), 1e-6) << "as the side is joined";

    const Design without = measured.with(removeElements(measured, std::vector{side}));
    EXPECT_TRUE(without.element(width));
    EXPECT_FALSE(without.element(edge)) << "nothing is left of it";
    EXPECT_TRUE(addMeasurement(design, from, from, "None").empty());
    EXPECT_TRUE(addMeasurement(design, from, {rail, {0, 0}}, "None").empty());
}

TEST_F(SplitMerge, MergesAlongSeveralSeamsInARow)
{
    // The seam in three pieces, the sides of the middle one swapped; `reversed` is the side that is walked
    // backwards.
    const Seam whole = *design.find<Seam>(seam);
    Seam lower = whole, middle = whole, upper = whole;
    lower.a.to = middle.a.from = 1.25;
    middle.a.to = upper.a.from = 1.75;
    ASSERT_TRUE(whole.reversed);
    lower.b = {side, 0.75, 1};
    middle.b = {side, 0.25, 0.75};
    upper.b = {side, 0, 0.25};
    std::swap(middle.a, middle.b);
    const ElementId third{21}, second{20};
    const Design rowed = design.with({{},
                                      {{seam, nullptr, makeElement(lower)},
                                       {second, nullptr, makeElement(middle)},
                                       {third, nullptr, makeElement(upper)}}});
    for (const ElementId id : {seam, second, third}) {
        const Outcome outcome = mergePatches(rowed, id);
        const Design after = done(rowed, outcome);
        EXPECT_TRUE(outcome.dropped.empty());
        after.each<Seam>([](ElementId, const Seam&) { ADD_FAILURE() << "no seam is left"; });
        const ElementId stays = id == second ? side : seat;
        EXPECT_NEAR(std::abs(after.find<Patch>(stays)->outline.signedArea()), 620 * 400, 1e-6);
        EXPECT_NEAR(length(after, after.find<FixationSeam>(fixation)->stretch), 500, 1e-6);
    }
}

TEST_F(SplitMerge, MergingWhatWasSplitGivesTheOldOutline)
{
    const Design halves = done(design, split({{-100, 120}, {900, 120}}));
    ElementId cut{};
    halves.each<Seam>([&](ElementId id, const Seam& s) { cut = s.continuity == Continuity::C1 ? id : cut; });
    const Outcome outcome = mergePatches(halves, cut);
    const Design whole = done(halves, outcome);
    const Patch& merged = *whole.find<Patch>(seat);
    EXPECT_EQ(merged.outline.pointCount(), 4);
    EXPECT_NEAR(merged.outline.signedArea(), 500 * 400, 1e-6);
    EXPECT_EQ(seamsBetween(whole, seat, side).size(), 1u);
}

int touchingHandles(const Design& design)
{
    int count = 0;
    for (const Problem& problem : checkDesign(design))
        count += problem.message.english().find("cross") != std::string::npos;
    return count;
}

TEST_F(SplitMerge, MergingJoinsWhatTheCutHadDivided)
{
    FancySeam upright = *design.find<FancySeam>(pipe);
    OutlineTrim trim{{seat, 2, 3}, {}, "welt"};
    Design start = design.with(addElement(design, makeElement(trim)));
    start = start.with(addElement(start, makeElement(EdgeAllowance{{seat, 3, 0}, 12, {}})));
    for (const std::vector<Vec2>& line :
         {std::vector<Vec2>{{210, 0}, {210, 500}}, {{-100, 120}, {900, 120}}, {{-100, 100}, {900, 350}}}) {
        const Design halves = done(start, splitPatch(start, seat, line));
        const ElementId piece = other(halves);
        ElementId cut{};
        halves.each<Seam>([&](ElementId id, const Seam& s) {
            if ((s.a.patch == piece && s.b.patch == seat) || (s.a.patch == seat && s.b.patch == piece))
                cut = id;
        });
        EXPECT_GT(halves.elements().size(), start.elements().size() + 2) << "something is divided";
        const Design whole = done(halves, mergePatches(halves, cut));
        EXPECT_EQ(whole.elements().size(), start.elements().size());
        EXPECT_EQ(touchingHandles(whole), 0);
        const auto* handle = whole.find<HandleCurve>(lumbar);
        ASSERT_TRUE(handle);
        EXPECT_EQ(handle->name, "Lumbar");
        EXPECT_EQ(handle->curve.pointCount(), 2) << "no knot is left where it was cut";
        EXPECT_LT((handle->curve.points().front() - Vec2(100, 300)).norm(), 1e-6);
        EXPECT_LT((handle->curve.points().back() - Vec2(400, 300)).norm(), 1e-6);
        EXPECT_EQ(handle->target.pointCount(), 2);
        EXPECT_LT((handle->target.points().back() - Vec3(400, 300, 40)).norm(), 1e-6);
        const auto* held = whole.find<FixationSeam>(fixation);
        ASSERT_TRUE(held);
        EXPECT_FALSE(held->curveRange) << "the whole rail";
        EXPECT_NEAR(length(whole, held->stretch), 500, 1e-6);
        EXPECT_NEAR(length(whole, seamsBetween(whole, seat, side).front().b), 400, 1e-6);
        EXPECT_EQ(whole.find<FancySeam>(pipe)->curve.pointCount(), upright.curve.pointCount());
    }
}

/// Both sides of a twin are cut and merged; the seams of each to the piece in the middle run opposite ways.
TEST(SplitMergeOfTwins, LosesNoSeam)
{
    std::ifstream file(test::samplesFolder() + "/../templates/dining-chair.json");
    const Design start = readDesign(std::string(std::istreambuf_iterator<char>(file), {})).design;
    const ElementId inner{28};
    ASSERT_TRUE(start.find<Patch>(inner));
    ASSERT_NE(twinOf(start, inner), noElement);
    const Box2 box = layoutBox(*start.find<Patch>(inner));
    for (const double share : {0.3, 0.5, 0.8}) {
        const double y = box.min().y() + share * box.sizes().y();
        const Outcome cut = splitPatch(start, inner, {{box.min().x() - 20, y}, {box.max().x() + 20, y}});
        ASSERT_TRUE(cut.problem.empty()) << cut.problem.english();
        const Design halves = start.with(withFollowers(start, cut.edit));
        EXPECT_EQ(halves.count<Seam>(), start.count<Seam>() + 6);
        ElementId seam{};
        halves.each<Seam>([&](ElementId id, const Seam& s) {
            const bool isNew = !start.find<Patch>(s.a.patch) || !start.find<Patch>(s.b.patch);
            if (isNew && (s.a.patch == inner || s.b.patch == inner))
                seam = id;
        });
        const Outcome merged = mergePatches(halves, seam);
        ASSERT_TRUE(merged.problem.empty()) << merged.problem.english();
        const Design whole = halves.with(withFollowers(halves, merged.edit));
        EXPECT_EQ(whole.count<Patch>(), start.count<Patch>());
        EXPECT_EQ(whole.count<Seam>(), start.count<Seam>());
        EXPECT_EQ(whole.count<FixationSeam>(), start.count<FixationSeam>());
        EXPECT_EQ(whole.count<HandleCurve>(), start.count<HandleCurve>());
        start.each<Seam>([&](ElementId, const Seam& s) {
            EXPECT_EQ(std::ssize(seamsOf(whole, s.a.patch, s.b.patch)), 1)
                << number(s.a.patch) << " and " << number(s.b.patch);
        });
    }
}

TEST_F(SplitMerge, SeamsThatMatchOtherPointsStayApart)
{
    // The side's corner lies a third of the way along the seat's edge: two seams, the first one with less ease.
    Design start = design.with(removeElements(design, std::vector{seam}));
    const Seam lower{{seat, 1, 1.25}, {side, 0.7, 1}, true}, upper{{seat, 1.25, 2}, {side, 0, 0.7}, true};
    for (const Seam& one : {lower, upper})
        start = start.with(addElement(start, makeElement(one)));
    const Design halves = done(start, splitPatch(start, seat, {{-100, 120}, {900, 120}}));
    ASSERT_EQ(seamsBetween(halves, seat, side).size() + seamsBetween(halves, other(halves), side).size(), 2u);
    ElementId cut{};
    halves.each<Seam>([&](ElementId id, const Seam& s) { cut = s.continuity == Continuity::C1 ? id : cut; });
    const Design whole = done(halves, mergePatches(halves, cut));
    EXPECT_EQ(seamsBetween(whole, seat, side).size(), 2u);
}

TEST_F(SplitMerge, AMirroredHalfMergesAlongTheMiddle)
{
    Design halves = design.with(removeElements(design, std::vector{side, pipe, lumbar}));
    const Edit copy = duplicatePatches(halves, std::vector{seat}, Vec2(0, 0));
    const ElementId right = addedPieces(copy).front();
    halves = halves.with(copy);
    halves = halves.with(mirrorPatches(halves, std::vector{right}, MirrorAxis::Vertical, 510));
    FixationSeam held = *halves.find<FixationSeam>(fixation);
    held.stretch.patch = right;
    halves = halves.with(addElement(halves, makeElement(held)));
    const Edit sewn = addElement(halves, makeElement(Seam{{seat, 1, 2}, {right, 1, 2}, false}));
    halves = halves.with(sewn);
    const Design whole = done(halves, mergePatches(halves, sewn.changes.front().id));
    EXPECT_NEAR(whole.find<Patch>(seat)->outline.signedArea(), 1000 * 400, 1e-6);
    int fixations = 0;
    whole.each<FixationSeam>([&](ElementId, const FixationSeam& h) {
        EXPECT_EQ(h.stretch.patch, seat);
        EXPECT_NEAR(length(whole, h.stretch), 500, 1e-6);
        const bool mirrored = h.reversed;
        const Vec2 start = whole.find<Patch>(seat)->outline.at(mirrored ? h.stretch.to : h.stretch.from);
        EXPECT_NEAR(start.x(), mirrored ? 1000 : 0, 1e-6) << "the rail begins at the outer corners";
        ++fixations;
    });
    EXPECT_EQ(fixations, 2);
}

TEST_F(SplitMerge, RefusesToMergeWhatDoesNotFit)
{
    const auto why = [](const Design& d, ElementId id) {
        const Outcome outcome = mergePatches(d, id);
        EXPECT_TRUE(outcome.edit.empty());
        return outcome.problem.english();
    };
    EXPECT_FALSE(why(design, seat).empty());
    Seam changed = *design.find<Seam>(seam);
    changed.b.to = 0.9;
    const auto with = [&](const Seam& s) {
        return design.with(replaceElement(design, seam, makeElement(s), {"x"}));
    };
    EXPECT_EQ(why(with(changed), seam), "The sides of the seam differ by 11.1 % in length, more than 5 %.");
    changed = *design.find<Seam>(seam);
    changed.reversed = false;
    EXPECT_EQ(why(with(changed), seam),
              "The seam joins the right side of Seat to the wrong side of Side: one patch cannot be both.");
    changed = {{seat, 1, 2}, {seat, 3, 4}};
    EXPECT_EQ(why(with(changed), seam), "The seam joins Seat to itself: there is nothing to merge.");
}

TEST_F(SplitMerge, SaysWhatIsDropped)
{
    FixationSeam onSeam = *design.find<FixationSeam>(fixation);
    onSeam.stretch = {seat, 1, 2};
    const Edit add = addElement(design, makeElement(onSeam));
    const Design held = design.with(add);
    const Outcome outcome = mergePatches(held, seam);
    EXPECT_EQ(outcome.dropped, std::vector{add.changes.front().id});
    EXPECT_FALSE(done(held, outcome).element(add.changes.front().id));
}

/// Does anything to patches of a design.
class Pattern {
public:
    Pattern(unsigned seed)
        : m_random(seed)
    {}

    Edit edit(const Design& design)
    {
        const std::vector<ElementId> ids = {any<Patch>(design), any<Patch>(design)};
        const Patch* patch = design.find<Patch>(ids[0]);
        if (!patch)
            return {};
        const Vec2 at = layoutBox(*patch).center() + test::randomPoint<2>(m_random, 50);
        const int point = m_random.whole(0, patch->outline.pointCount() - 1);
        switch (m_random.whole(0, 11)) {
        case 0:
            return scalePatches(design, ids, at, {m_random.real(0.7, 1.4), m_random.real(0.7, 1.4)});
        case 1:
            return movePatchPoints(design, ids[0], std::array{point}, test::randomPoint<2>(m_random, 10));
        case 2:
            return mirrorPatches(design, ids, m_random.chance(0.5) ? MirrorAxis::Vertical : MirrorAxis::Horizontal,
                                 at.x());
        case 3:
            return duplicatePatches(design, ids, at);
        case 4:
            return alignPatches(design, ids, static_cast<Alignment>(m_random.whole(0, 5)));
        case 5:
            return arrangePatches(design, {});
        case 6:
            return makeCorners(design, ids[0], std::vector{point});
        case 7:
            return makeSmooth(design, ids[0], std::vector{point});
        case 8:
            return straighten(design, ids[0], point, (point + 2) % patch->outline.pointCount());
        case 9:
            return paste(design, copyText(design, ids), at).edit;
        case 10:
            return mergePatches(design, any<Seam>(design)).edit;
        default: {
            const Vec2 way = Eigen::Rotation2Dd(m_random.real(0, 3)) * Vec2(5000, 0);
            return splitPatch(design, ids[0], {at - way, at, at + way}).edit;
        }
        }
    }

private:
    template <class T>
    ElementId any(const Design& design)
    {
        std::vector<ElementId> ids;
        design.each<T>([&](ElementId id, const T&) { ids.push_back(id); });
        return ids.empty() ? ElementId{}
                           : ids[static_cast<std::size_t>(m_random.whole(0, static_cast<int>(ids.size()) - 1))];
    }

    test::Random m_random;
};

/// Errors of a kind that these edits may cause: changed shapes may make an outline cross itself, and mirroring may
/// sew a smooth seam from right to wrong side; nothing else.
TEST(RandomPatternEdits, UndoToTheSameAndBreakNothing)
{
    for (const char* name : test::designNames) {
        const Design start = test::soundDesign(test::designText(name));
        for (unsigned seed = 0; seed < 5; ++seed) {
            Pattern pattern(seed);
            Design design = start;
            std::vector<std::pair<Design, Edit>> history;
            for (int i = 0; i < 25; ++i) {
                const Edit edit = pattern.edit(design);
                if (edit.empty())
                    continue;
                const Design after = design.with(edit);
                ASSERT_EQ(after.with(edit.inverse()), design) << name << " " << seed << " " << i;
                if (errors(after) > 0) { // a shape that nobody would keep
                    for (const Problem& problem : checkDesign(after))
                        if (problem.severity == Severity::Error) {
                            EXPECT_EQ(problem.field, "outline.points")
                                << name << " " << seed << " " << edit.verb.english() << ": " << problem.english();
                        }
                    continue;
                }
                history.emplace_back(design, edit);
                design = after;
            }
            EXPECT_GT(history.size(), 8u) << name << " " << seed;
            EXPECT_EQ(readDesign(writeDesign(design)).design, design);
            for (auto step = history.rbegin(); step != history.rend(); ++step)
                design = design.with(step->second.inverse());
            EXPECT_EQ(writeDesign(design), writeDesign(start));
        }
    }
}

} // namespace
} // namespace bolster::splitting
