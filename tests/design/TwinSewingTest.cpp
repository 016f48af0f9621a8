// Seams, fixations and what is drawn in mirror twins: both sides follow each other.
#include "CurveEdits.h"
#include "DesignCheck.h"
#include "EditCheck.h"
#include "ElementEdits.h"
#include "FixationEdits.h"
#include "PatchEdits.h"
#include "PatchMerge.h"
#include "PatchSplit.h"
#include "SeamEdits.h"
#include "TwinEdits.h"
#include "Twins.h"

#include "Random.h"
#include "TestData.h"

namespace bolster::twinSewing { // names that other tests have, too
namespace {

using namespace edits;

// A side piece and a bolster, not sewn yet, a seat that is its own mirror image, and a rail at the side.
constexpr const char* halfDesign = R"({"format": "bolster-design", "version": 1, "unit": "mm", "elements": [
  {"id": 1, "kind": "fabric", "name": "Leather"},
  {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1,
   "outline": {"degree": 1, "closed": true, "points": [[-200,0],[200,0],[200,400],[-200,400]]}},
  {"id": 3, "kind": "patch", "name": "left side", "fabric": 1, "position": [400, 0],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[100,0],[100,400],[0,400]]}},
  {"id": 4, "kind": "patch", "name": "left bolster", "fabric": 1, "position": [600, 0],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[150,0],[150,400],[0,400]]}},
  {"id": 5, "kind": "fixation_curve", "name": "left rail",
   "curve": {"degree": 1, "closed": false, "points": [[-300,0,0],[-310,200,50],[-300,400,0]]}},
  {"id": 6, "kind": "fixation_seam", "patch": 4, "from": 1, "to": 2, "curve": 5, "normal": [-1, 0, 1]}]})";

constexpr ElementId seat{2}, side{3}, bolster{4}, rail{5}, railFixation{6};

/// As far as a drag keeps it: what breaks something is not kept.
Edit seamEndMoved(const Design& design, ElementId seam, SeamSide side, StretchEnd end, double parameter)
{
    const Edit edit = dragStretchEnd(design, seam, side, end, parameter);
    return brokenBy(design, edit) ? Edit{} : edit;
}

class TwinSewingTest : public testing::Test {
protected:
    TwinSewingTest()
    {
        apply(makeTwins(design, std::array{side, bolster}, [](const std::string& name) { return name + "'"; }));
        sideTwin = twinOf(design, side);
        bolsterTwin = twinOf(design, bolster);
        railTwin = twinOf(design, rail);
    }

    /// As a document does.
    void apply(const Edit& edit)
    {
        const Edit whole = withTwins(design, edit);
        ASSERT_TRUE(design.with(whole).with(whole.inverse()) == design) << "undo gives an equal design";
        ASSERT_TRUE(design.with(withTwins(design, whole)) == design.with(whole)) << "once is enough";
        design = design.with(whole);
    }

    /// The new seam.
    ElementId sew(const Stretch& a, const Stretch& b, bool reversed = true)
    {
        const ElementId id = design.nextId();
        Message problem;
        apply(addSeam(design, a, b, reversed, &problem));
        EXPECT_TRUE(design.find<Seam>(id)) << problem.english();
        return id;
    }

    template <class T>
    int count() const
    {
        int result = 0;
        design.each<T>([&](ElementId, const T&) { ++result; });
        return result;
    }
    const Seam& seam(ElementId id) const { return *design.find<Seam>(id); }
    const FixationSeam& fixation(ElementId id) const { return *design.find<FixationSeam>(id); }
    std::vector<int> pointsOf(const Stretch& stretch) const
    {
        return pointsOnStretch(design.find<Patch>(stretch.patch)->outline, stretch.from, stretch.to);
    }

    Design design = test::soundDesign(halfDesign);
    ElementId sideTwin{}, bolsterTwin{}, railTwin{};
};

TEST_F(TwinSewingTest, ASeamBetweenTwinsIsSewnOnBothSides)
{
    const ElementId made = sew({side, 1, 2}, {bolster, 3, 4});
    ASSERT_EQ(count<Seam>(), 2);
    const ElementId mirrored = mirroredElement(design, made);
    ASSERT_NE(mirrored, noElement);
    EXPECT_EQ(seam(mirrored).a, (Stretch{sideTwin, 1, 2}));
    EXPECT_EQ(seam(mirrored).b, (Stretch{bolsterTwin, 3, 4}));
    EXPECT_TRUE(seam(mirrored).reversed);
    EXPECT_EQ(mirroredElement(design, mirrored), made);

    apply(setContinuity(design, std::array{mirrored}, Continuity::G1));
    EXPECT_EQ(seam(made).continuity, Continuity::G1);
    apply(setMatch(design, std::array{made}, Match::Parameter));
    EXPECT_EQ(seam(mirrored).match, Match::Parameter);
    apply(flipSeams(design, std::array{made}));
    EXPECT_FALSE(seam(mirrored).reversed);
    apply(seamEndMoved(design, mirrored, SeamSide::A, StretchEnd::To, 1.75));
    EXPECT_EQ(seam(made).a, (Stretch{side, 1, 1.75}));
    apply(swapSeamSides(design, std::array{made}));
    EXPECT_EQ(mirroredElement(design, made), mirrored);
    apply(seamEndMoved(design, made, SeamSide::A, StretchEnd::From, 3.25));
    EXPECT_EQ(seam(mirrored).a, (Stretch{bolsterTwin, 3.25, 4}));

    apply(removeElements(design, std::array{mirrored}));
    EXPECT_EQ(count<Seam>(), 0);
}

TEST_F(TwinSewingTest, APieceThatIsItsOwnMirrorImageIsSewnOnBothSides)
{
    const ElementId made = sew({seat, 1, 2}, {side, 3, 4});
    ASSERT_EQ(count<Seam>(), 2);
    const ElementId mirrored = mirroredElement(design, made);
    ASSERT_NE(mirrored, noElement);
    EXPECT_EQ(seam(mirrored).a, (Stretch{seat, 3, 0})) << "the other edge of the seat";
    EXPECT_EQ(seam(mirrored).b, (Stretch{sideTwin, 3, 4}));
    EXPECT_FALSE(seam(mirrored).reversed) << "the twin's outline runs the other way round";

    apply(seamEndMoved(design, mirrored, SeamSide::A, StretchEnd::From, 3.5));
    EXPECT_EQ(seam(made).a, (Stretch{seat, 1, 1.5}));
    Patch nearly = *design.find<Patch>(seat);
    nearly.outline = nearly.outline.withPoint(1, Vec2(200.4, 0.3));
    apply(replaceElement(design, seat, makeElement(nearly), {}));
    EXPECT_EQ(mirroredElement(design, made), mirrored) << "within a millimetre it still is";
    EXPECT_TRUE(relinkSewing(design, made).empty());
    EXPECT_TRUE(relinkSewing(design, mirrored).empty());
    apply(flipSeams(design, std::array{made}));
    EXPECT_TRUE(seam(mirrored).reversed);
    // Its top lies across the middle: there is no other one.
    sew({seat, 2, 3}, {bolster, 3, 4});
    EXPECT_EQ(count<Seam>(), 3);
}

TEST_F(TwinSewingTest, WhatIsInTheWayStays)
{
    // Before they were twins.
    design = test::soundDesign(halfDesign);
    apply(makeTwins(design, std::array{side}, [](const std::string& name) { return name; }));
    const ElementId there = sew({twinOf(design, side), 1, 2}, {bolster, 3, 4});
    EXPECT_EQ(count<Seam>(), 1) << "the bolster has no twin, and its other edge is fixed";
    apply(makeTwins(design, std::array{bolster}, [](const std::string& name) { return name; }));
    const int before = count<Seam>();
    EXPECT_EQ(before, 2);
    apply(removeElements(design, std::array{there}));
    EXPECT_EQ(count<Seam>(), 0);
}

TEST_F(TwinSewingTest, ASeamToTheOwnTwinStaysSymmetric)
{
    const ElementId made = sew({side, 3, 4}, {sideTwin, 3, 4}, false);
    EXPECT_EQ(count<Seam>(), 1) << "it is its own mirror image";
    EXPECT_EQ(mirroredElement(design, made), made);
    apply(seamEndMoved(design, made, SeamSide::B, StretchEnd::From, 3.5));
    EXPECT_EQ(seam(made).a, (Stretch{side, 3.5, 4}));
    const ElementId crossed = sew({side, 0, 1}, {sideTwin, 2, 3}, false);
    EXPECT_EQ(count<Seam>(), 3);
    EXPECT_EQ(seam(mirroredElement(design, crossed)).a, (Stretch{sideTwin, 0, 1}));
    apply(setContinuity(design, std::array{crossed}, Continuity::C1));
    EXPECT_EQ(seam(mirroredElement(design, crossed)).continuity, Continuity::C1);
}

TEST_F(TwinSewingTest, ReleasedStretchesAreSewnAlone)
{
    const ElementId made = sew({side, 1, 2}, {bolster, 3, 4});
    const ElementId mirrored = mirroredElement(design, made);
    EXPECT_FALSE(sewingReleased(design, made));
    apply(releasePoints(design, side, pointsOf(seam(made).a)));
    EXPECT_FALSE(sewingReleased(design, made)) << "the bolster still follows";
    apply(releasePoints(design, bolster, pointsOf(seam(made).b)));
    EXPECT_TRUE(sewingReleased(design, made));
    EXPECT_TRUE(sewingReleased(design, mirrored));

    apply(setContinuity(design, std::array{made}, Continuity::G1));
    EXPECT_EQ(seam(mirrored).continuity, Continuity::C0);
    apply(seamEndMoved(design, made, SeamSide::B, StretchEnd::To, 3.75));
    EXPECT_EQ(seam(mirrored).b, (Stretch{bolsterTwin, 3, 4}));
    EXPECT_EQ(mirroredElement(design, made), noElement) << "they lie elsewhere now";
    apply(removeElements(design, std::array{railFixation}));

    apply(relinkPoints(design, side, releasedPoints(design, side)));
    apply(relinkSewing(design, made));
    EXPECT_EQ(seam(made).b, (Stretch{bolster, 3, 4}));
    EXPECT_EQ(seam(made).continuity, Continuity::C0);
    EXPECT_EQ(mirroredElement(design, made), mirrored);
    EXPECT_TRUE(relinkSewing(design, made).empty());
    apply(setContinuity(design, std::array{made}, Continuity::C1));
    EXPECT_EQ(seam(mirrored).continuity, Continuity::C1);

    // A belt notch on one side: released first, then sewn.
    apply(releasePoints(design, side, std::array{0, 3}));
    sew({side, 3, 4}, {seat, 1, 2});
    EXPECT_EQ(count<Seam>(), 3);
}

TEST_F(TwinSewingTest, ThePartOfAStraightEdgeCanBeReleased)
{
    EXPECT_EQ(pointsOf({side, 1.2, 1.4}), std::vector{1});
    EXPECT_EQ(pointsOf({side, 1.3, 1.8}), (std::vector{1, 2}));
}

TEST_F(TwinSewingTest, FixationsFollow)
{
    const ElementId mirrored = mirroredElement(design, railFixation);
    ASSERT_NE(mirrored, noElement);
    FixationSeam changed = fixation(railFixation);
    changed.curveRange = std::pair(0.0, 1.5);
    changed.reversed = true;
    changed.stretch.to = 1.75;
    changed.orientation.directions = {Vec3(-1, 2, 3)};
    apply(replaceElement(design, railFixation, makeElement(changed), {}));
    EXPECT_EQ(fixation(mirrored).curve, railTwin);
    EXPECT_EQ(fixation(mirrored).curveRange, changed.curveRange);
    EXPECT_TRUE(fixation(mirrored).reversed);
    EXPECT_EQ(fixation(mirrored).stretch, (Stretch{bolsterTwin, 1, 1.75}));
    EXPECT_EQ(fixation(mirrored).orientation.directions.front(), Vec3(1, 2, 3));
    apply(removeElements(design, std::array{mirrored}));
    EXPECT_EQ(count<FixationSeam>(), 0);
    EXPECT_EQ(count<FixationCurve>(), 2);

    // A curve that comes with its fixation gets a twin.
    FixationSeam held;
    held.stretch = {side, 0, 1};
    FixationCurve curve;
    curve.name = "Hem";
    curve.curve = BSpline3(1, false, {Vec3(-100, 0, 0), Vec3(-200, 10, 20)});
    held.curve = design.nextId();
    const Design with = design.with(addElement(design, makeElement(curve)));
    apply(editBetween(design, with.with(addElement(with, makeElement(held))), {}));
    EXPECT_EQ(count<FixationSeam>(), 2);
    ASSERT_NE(twinOf(design, held.curve), noElement);
    const FixationCurve& twin = *design.find<FixationCurve>(twinOf(design, held.curve));
    EXPECT_EQ(twin.name, "Hem 2");
    EXPECT_EQ(twin.curve.at(1), Vec3(200, 10, 20));

    apply(removeElements(design, std::array{held.curve}));
    EXPECT_EQ(count<FixationSeam>(), 1) << "the removal of a curve only unlinks the other one";
    EXPECT_EQ(count<FixationCurve>(), 3);
}

TEST_F(TwinSewingTest, OneStretchToSeveralCurvesOnBothSides)
{
    FixationCurve lower, upper;
    lower.curve = BSpline3(1, false, {Vec3(-300, 0, 0), Vec3(-310, 200, 50)});
    upper.curve = BSpline3(1, false, {Vec3(-310, 200, 50), Vec3(-300, 400, 0)});
    const ElementId first = design.nextId();
    apply(addElement(design, makeElement(lower)));
    const ElementId second = design.nextId();
    apply(addElement(design, makeElement(upper)));
    const auto same = [](const std::string& name) { return name; };
    // Without twins of the curves the other side keeps what it has.
    const Design start = design;
    apply(attachToCurves(design, {bolster, 1, 2}, std::array{first, second}, nullptr));
    EXPECT_EQ(count<FixationSeam>(), 3);
    design = start;
    apply(makeTwins(design, std::array{first, second}, same));
    apply(attachToCurves(design, {bolster, 1, 2}, std::array{first, second}, nullptr));
    EXPECT_EQ(count<FixationSeam>(), 4);
}

TEST_F(TwinSewingTest, DrawnCurvesComeAndGoOnBothSides)
{
    FancySeam pipe;
    pipe.name = "Pipe";
    pipe.patch = side;
    pipe.curve = BSpline2(1, false, {Vec2(20, 100), Vec2(80, 300)});
    const ElementId made = design.nextId();
    apply(addElement(design, makeElement(pipe)));
    const ElementId twin = twinOf(design, made);
    ASSERT_NE(twin, noElement);
    EXPECT_EQ(design.find<FancySeam>(twin)->patch, sideTwin);
    EXPECT_EQ(design.find<FancySeam>(twin)->curve.at(0), Vec2(-20, 100));
    apply(removeElements(design, std::array{twin}));
    EXPECT_EQ(count<FancySeam>(), 0);

    HandleCurve handle;
    handle.patch = bolster;
    handle.curve = pipe.curve;
    handle.orientation.directions = {Vec3(1, 0, 1)};
    const ElementId held = design.nextId();
    apply(addElement(design, makeElement(handle)));
    ASSERT_NE(twinOf(design, held), noElement);
    EXPECT_EQ(design.find<HandleCurve>(twinOf(design, held))->orientation.directions.front(), Vec3(-1, 0, 1));
    apply(removeElements(design, std::array{bolster}));
    EXPECT_EQ(count<HandleCurve>(), 1) << "the twin keeps what is drawn in it";
}

TEST_F(TwinSewingTest, TwinsAreSplitAndMergedOnBothSides)
{
    const ElementId made = sew({side, 1, 2}, {bolster, 3, 4});
    const Design start = design;
    const int patches = count<Patch>();
    Outcome split = splitPatch(design, side, {Vec2(390, 150), Vec2(510, 170)});
    ASSERT_FALSE(split.edit.empty()) << split.problem.english();
    apply(split.edit);
    EXPECT_EQ(count<Patch>(), patches + 2);
    EXPECT_EQ(twinOf(design, side), sideTwin);
    for (const auto& [follower, original] : twinPairs(design))
        EXPECT_EQ(unlikePoints(*design.element(original), *design.element(follower), symmetryOf(design)), 0);
    EXPECT_EQ(twinPairs(design).size(), 4u) << "the cut off pieces are twins";
    EXPECT_EQ(count<Seam>(), 6);
    design.each<Seam>([&](ElementId id, const Seam&) { EXPECT_NE(mirroredElement(design, id), noElement); });

    design = start;
    const Outcome merged = mergePatches(design, made);
    ASSERT_FALSE(merged.edit.empty()) << merged.problem.english();
    apply(merged.edit);
    EXPECT_EQ(count<Patch>(), patches - 2);
    EXPECT_EQ(twinOf(design, side), sideTwin);
    EXPECT_EQ(unlikePoints(*design.element(side), *design.element(sideTwin), symmetryOf(design)), 0);
    EXPECT_EQ(count<FixationSeam>(), 2);

    // With what has no twin: its own way from then on.
    design = start;
    const ElementId top = sew({side, 2, 3}, {seat, 0, 1});
    const Patch before = *design.find<Patch>(sideTwin);
    Seam narrow = seam(top);
    narrow.b.to = 0.25;
    apply(replaceElement(design, top, makeElement(narrow), {}));
    const Outcome single = mergePatches(design, top);
    ASSERT_FALSE(single.edit.empty()) << single.problem.english();
    apply(single.edit);
    EXPECT_EQ(twinOf(design, side), noElement);
    EXPECT_EQ(design.find<Patch>(sideTwin)->outline, before.outline);
}

/// Every seam and fixation on twins that is not released has a counterpart with the same properties.
class TwinSewingByChance : public TwinSewingTest {
protected:
    void step(test::Random& random)
    {
        const auto any = [&](auto... ids) {
            return std::array{ids...}[static_cast<std::size_t>(random.whole(0, sizeof...(ids) - 1))];
        };
        const ElementId patch = any(side, bolster, sideTwin, bolsterTwin);
        const std::vector<ElementId> seams = all<Seam>();
        const ElementId one = seams.empty() ? noElement : seams[random.whole(0, 1000) % seams.size()];
        const double at = random.whole(0, 11) / 4.0;
        switch (random.whole(0, 11)) {
        case 0:
        case 1:
        case 2:
            apply(addSeam(design, {patch, at, at + 0.75},
                          {any(side, bolster, sideTwin, bolsterTwin), at + 1, at + 1.5}, random.chance(0.5)));
            break;
        case 3:
            apply(setContinuity(design, std::array{one}, any(Continuity::C0, Continuity::C1, Continuity::G1)));
            break;
        case 4:
            apply(flipSeams(design, std::array{one}));
            break;
        case 5:
            apply(setMatch(design, std::array{one}, any(Match::Length, Match::Parameter)));
            break;
        case 6:
            apply(swapSeamSides(design, std::array{one}));
            break;
        case 7:
            apply(seamEndMoved(design, one, any(SeamSide::A, SeamSide::B), any(StretchEnd::From, StretchEnd::To),
                               random.real(0, 4)));
            break;
        case 8:
            if (random.chance(0.4))
                apply(removeElements(design, std::array{one}));
            break;
        case 9:
            apply(movePatchPoints(design, patch, std::array{random.whole(0, 3)}, test::randomPoint<2>(random, 5)));
            break;
        case 10:
            apply(insertPatchPoint(design, patch, random.real(0, 4)));
            break;
        default:
            apply(attachStretch(design, {patch, at, at + 0.5}, any(rail, railTwin), nullptr));
        }
    }

    template <class T>
    std::vector<ElementId> all() const
    {
        std::vector<ElementId> ids;
        design.each<T>([&](ElementId id, const T&) { ids.push_back(id); });
        return ids;
    }

    bool onTwinsOnly(const Seam& s) const
    {
        return twinOf(design, s.a.patch) != noElement && twinOf(design, s.b.patch) != noElement;
    }
};

TEST_F(TwinSewingByChance, BothSidesStayAlike)
{
    const Design start = design;
    int sewn = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        design = start;
        test::Random random(seed);
        for (int i = 0; i < 50; ++i) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << ", step " << i);
            step(random);
            design.each<Seam>([&](ElementId id, const Seam& s) {
                const Seam* other = design.find<Seam>(mirroredElement(design, id));
                if (!onTwinsOnly(s))
                    return;
                ++sewn;
                ASSERT_TRUE(other) << number(id);
                EXPECT_EQ(s.continuity, other->continuity);
                EXPECT_EQ(s.match, other->match);
                EXPECT_EQ(s.reversed, other->reversed);
            });
            design.each<FixationSeam>([&](ElementId id, const FixationSeam&) {
                EXPECT_NE(mirroredElement(design, id), noElement) << number(id);
            });
            if (HasFailure())
                return;
        }
        EXPECT_TRUE(test::soundDesign(writeDesign(design)) == design);
    }
    EXPECT_GT(sewn, 1000);
}

} // namespace
} // namespace bolster::twinSewing
