// Mirror twins: whichever of two is edited, the other follows.
#include "Twins.h"
#include "CurveEdits.h"
#include "CuttingEdits.h"
#include "DesignCheck.h"
#include "ElementEdits.h"
#include "PatchEdits.h"
#include "TwinEdits.h"

#include "Random.h"
#include "TestData.h"

namespace bolster::twins { // names that other tests have, too
namespace {

using namespace edits;

// A side piece that is sewn to a seat and fixed to a rail at the side and one at the front that is its own mirror
// image.
constexpr const char* halfDesign = R"({"format": "bolster-design", "version": 1, "unit": "mm", "elements": [
  {"id": 1, "kind": "fabric", "name": "Leather"},
  {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1,
   "outline": {"degree": 1, "closed": true, "points": [[-200,0],[200,0],[200,400],[-200,400]]}},
  {"id": 3, "kind": "patch", "name": "left side", "fabric": 1, "position": [400, 10], "rotation": 20, "grain": 80,
   "outline": {"degree": 3, "closed": true, "corners": [0, 3, 6, 9],
    "points": [[0,0],[30,-10],[60,5],[100,0],[95,130],[105,260],[100,400],[60,410],[30,400],[0,400],[0,260],[0,130]]}},
  {"id": 4, "kind": "seam", "a": {"patch": 2, "from": 1, "to": 2}, "b": {"patch": 3, "from": 9, "to": 0}},
  {"id": 5, "kind": "fixation_curve", "name": "left rail",
   "curve": {"degree": 1, "closed": false, "points": [[-300,0,0],[-310,200,50],[-300,400,0]]}},
  {"id": 6, "kind": "fixation_seam", "patch": 3, "from": 3, "to": 6, "curve": 5, "normal": [-1, 0, 1]},
  {"id": 7, "kind": "fixation_curve", "name": "Front rail",
   "curve": {"degree": 1, "closed": false, "points": [[-300,0,0],[-150,0,20],[150,0,20],[300,0,0]]}},
  {"id": 8, "kind": "fixation_seam", "patch": 3, "from": 0, "to": 3, "curve": 7, "curve_from": 0, "curve_to": 1},
  {"id": 9, "kind": "fancy_seam", "name": "Pipe", "patch": 3,
   "curve": {"degree": 1, "closed": false, "points": [[20,100],[80,300]]}}]})";

constexpr ElementId seat{2}, side{3}, rail{5}, front{7}, pipe{9};

std::string rightOf(const std::string& name)
{
    return name.rfind("left", 0) == 0 ? "right" + name.substr(4) : name;
}

class TwinsTest : public testing::Test {
protected:
    TwinsTest()
    {
        apply(makeTwins(design, std::array{side}, rightOf));
        twin = twinOf(design, side);
        twinRail = twinOf(design, rail);
    }

    /// As a document does.
    void apply(const Edit& edit)
    {
        const Edit whole = withTwins(design, edit);
        ASSERT_TRUE(design.with(whole).with(whole.inverse()) == design) << "undo gives an equal design";
        ASSERT_TRUE(design.with(withTwins(design, whole)) == design.with(whole)) << "once is enough";
        design = design.with(whole);
    }

    const Patch& patch(ElementId id) const { return *design.find<Patch>(id); }
    Vec2 point(ElementId id, int i) const { return patch(id).outline.points()[static_cast<std::size_t>(i)]; }
    int unlike(ElementId follower) const
    {
        const Element& element = *design.element(follower);
        return unlikePoints(*design.element(twinLink(element)->of), element, symmetryOf(design));
    }

    Design design = test::soundDesign(halfDesign);
    ElementId twin{}, twinRail{};
};

TEST_F(TwinsTest, AreMadeWithAllThatBelongsToThem)
{
    ASSERT_NE(twin, noElement);
    EXPECT_TRUE(design.settings().symmetry);
    EXPECT_EQ(patch(twin).name, "right side");
    EXPECT_EQ(patch(twin).grain, 100);
    EXPECT_EQ(patch(twin).position, Vec2(-400, 10));
    EXPECT_EQ(patch(twin).rotation, -20);
    EXPECT_EQ(point(twin, 3), Vec2(-100, 0));
    EXPECT_EQ(patch(twin).outline.knots(), patch(side).outline.knots());

    std::vector<Seam> seams;
    design.each<Seam>([&](ElementId, const Seam& seam) { seams.push_back(seam); });
    ASSERT_EQ(seams.size(), 2u);
    EXPECT_EQ(seams[1].a, (Stretch{seat, 3, 0})) << "the other side of the seat";
    EXPECT_EQ(seams[1].b, (Stretch{twin, 9, 0}));
    EXPECT_FALSE(seams[1].reversed) << "the twin's outline runs the other way round";

    std::vector<FixationSeam> fixations;
    design.each<FixationSeam>([&](ElementId, const FixationSeam& seam) { fixations.push_back(seam); });
    ASSERT_EQ(fixations.size(), 4u);
    EXPECT_EQ(fixations[2].curve, twinRail);
    EXPECT_EQ(fixations[2].orientation.directions.front(), Vec3(1, 0, 1));
    EXPECT_EQ(fixations[3].curve, front) << "its own mirror image";
    EXPECT_EQ(fixations[3].curveRange, std::pair(2.0, 3.0));
    EXPECT_TRUE(fixations[3].reversed);
    EXPECT_EQ(design.find<FixationCurve>(twinRail)->curve.points()[1], Vec3(310, 200, 50));
    EXPECT_EQ(design.find<FixationCurve>(twinRail)->name, "right rail");

    const FancySeam& fancy = *design.find<FancySeam>(twinOf(design, pipe));
    EXPECT_EQ(fancy.patch, twin);
    EXPECT_EQ(fancy.curve.at(1), Vec2(-80, 300));
    for (const Problem& problem : checkDesign(design))
        EXPECT_EQ(problem.element, seat) << problem.english(); // wholly held by the sides
    EXPECT_TRUE(makeTwins(design, std::array{side}, rightOf).empty()) << "there is one already";
}

TEST_F(TwinsTest, AreNotSewnWhereSomethingIs)
{
    design = test::soundDesign(halfDesign);
    FixationSeam taken;
    taken.stretch = {seat, 3, 0};
    taken.curve = front;
    apply(addElement(design, makeElement(taken)));
    apply(makeTwins(design, std::array{side}, rightOf));
    int seams = 0;
    design.each<Seam>([&](ElementId, const Seam&) { ++seams; });
    EXPECT_EQ(seams, 1);
}

TEST_F(TwinsTest, FollowEachOther)
{
    apply(movePatchPoints(design, side, std::array{4}, Vec2(5, 7)));
    EXPECT_EQ(point(twin, 4), Vec2(-100, 137));
    apply(movePatchPoints(design, twin, std::array{4}, Vec2(-1, 0)));
    EXPECT_EQ(point(side, 4), Vec2(101, 137));
    apply(moveCurvePoints(design, twinRail, std::array{1}, Vec3(1, 2, 3)));
    EXPECT_EQ(design.find<FixationCurve>(rail)->curve.points()[1], Vec3(-311, 202, 53));

    apply(insertPatchPoint(design, twin, 4.5));
    EXPECT_EQ(patch(side).outline.pointCount(), 13);
    EXPECT_EQ(unlike(twin), 0);
    apply(removePatchPoint(design, side, 4));
    EXPECT_EQ(patch(twin).outline.pointCount(), 12);
    EXPECT_EQ(unlike(twin), 0);

    Patch changed = patch(twin);
    changed.grain = 30;
    changed.pressure = 0.25;
    changed.name = "Another";
    changed.position = {1, 2};
    apply(replaceElement(design, twin, makeElement(changed), {}));
    EXPECT_EQ(patch(side).grain, 150);
    EXPECT_EQ(patch(side).pressure, 0.25);
    EXPECT_EQ(patch(side).name, "left side");
    EXPECT_EQ(patch(side).position, Vec2(400, 10)) << "places in the layout are free";
}

TEST_F(TwinsTest, TheOriginalWinsWhenBothMove)
{
    const Edit first = movePatchPoints(design, side, std::array{4, 5}, Vec2(5, 0));
    const Design moved = design.with(first);
    const Edit both =
        editBetween(design, moved.with(movePatchPoints(moved, twin, std::array{5, 7}, Vec2(5, 0))), {});
    apply(both);
    EXPECT_EQ(point(twin, 4), Vec2(-100, 130));
    EXPECT_EQ(point(twin, 5), Vec2(-110, 260));
    EXPECT_EQ(point(side, 7), Vec2(55, 410));
    EXPECT_EQ(unlike(twin), 0);
}

TEST_F(TwinsTest, ReleasedPointsGoTheirOwnWays)
{
    apply(releasePoints(design, side, std::array{4, 5}));
    EXPECT_EQ(releasedPoints(design, twin), (std::vector{4, 5}));
    apply(movePatchPoints(design, side, std::array{4, 5, 7}, Vec2(5, 0)));
    EXPECT_EQ(point(twin, 4), Vec2(-95, 130));
    EXPECT_EQ(point(twin, 7), Vec2(-65, 410));
    EXPECT_EQ(unlike(twin), 0);

    // The exception stays one when points come and go, and each side keeps its shape.
    const BSpline2 before = patch(twin).outline;
    apply(insertPatchPoint(design, side, 1.5));
    EXPECT_EQ(releasedPoints(design, side), (std::vector{5, 6}));
    apply(insertPatchPoint(design, side, 4.4));
    EXPECT_LT((patch(twin).outline.at(4.2) - before.at(4.2)).norm(), 1e-9);
    EXPECT_EQ(unlike(twin), 0);
    apply(removePatchPoint(design, twin, 1));
    EXPECT_EQ(unlike(twin), 0);

    // All of it: the exception comes along.
    const int released = releasedPoints(design, side).front();
    std::vector<int> all;
    for (int i = 0; i < patch(side).outline.pointCount(); ++i)
        all.push_back(i);
    const Vec2 old = point(twin, released);
    apply(movePatchPoints(design, side, all, Vec2(10, 1)));
    EXPECT_LT((point(twin, released) - (old + Vec2(-10, 1))).norm(), 1e-9);

    const std::vector<int> exceptions = releasedPoints(design, side);
    const BSpline2 kept = patch(side).outline;
    apply(relinkPoints(design, twin, exceptions));
    EXPECT_TRUE(releasedPoints(design, side).empty());
    EXPECT_EQ(patch(side).outline, kept) << "those of the other one jump";
    EXPECT_EQ(unlike(twin), 0);
    EXPECT_TRUE(relinkPoints(design, twin, exceptions).empty());
}

TEST_F(TwinsTest, SeamsFollowOutlinesThatGetOtherKnots)
{
    // As an edit does that makes an outline anew: twice the parameters, and the seams are told.
    Patch patchNow = patch(side);
    std::vector<double> knots = patchNow.outline.knots();
    for (double& knot : knots)
        knot *= 2;
    patchNow.outline = BSpline2(3, true, patchNow.outline.points(), knots);
    Edit edit{{}, {{side, nullptr, makeElement(patchNow)}}};
    for (const auto& [id, element] : design.elements()) {
        Element changed = *element;
        const auto twice = [](Stretch& s) {
            if (s.patch == side)
                s = {side, 2 * s.from, 2 * s.to};
        };
        if (auto* seam = std::get_if<Seam>(&changed))
            twice(seam->b);
        if (auto* fixation = std::get_if<FixationSeam>(&changed))
            twice(fixation->stretch);
        if (!(changed == *element))
            edit.changes.push_back({id, nullptr, std::make_shared<const Element>(changed)});
    }
    apply(edit);
    EXPECT_EQ(unlike(twin), 0);
    std::vector<Stretch> onTwin;
    design.each<Seam>([&](ElementId, const Seam& seam) { onTwin.push_back(seam.b); });
    design.each<FixationSeam>([&](ElementId, const FixationSeam& seam) { onTwin.push_back(seam.stretch); });
    std::erase_if(onTwin, [&](const Stretch& stretch) { return stretch.patch != twin; });
    EXPECT_EQ(onTwin, (std::vector<Stretch>{{twin, 18, 0}, {twin, 6, 12}, {twin, 0, 6}}));
}

TEST_F(TwinsTest, PointsOfAStretch)
{
    const BSpline2& outline = patch(side).outline;
    EXPECT_EQ(pointsOnStretch(outline, 3, 6), (std::vector{3, 4, 5, 6}));
    EXPECT_EQ(pointsOnStretch(outline, 9, 0), (std::vector{0, 9, 10, 11}));
    EXPECT_EQ(pointsOnStretch(outline, 6, 6).size(), 12u);
}

TEST_F(TwinsTest, LinksEndWithOneOfThem)
{
    const Design start = design;
    apply(removeElements(design, std::array{side}));
    ASSERT_TRUE(design.find<Patch>(twin));
    EXPECT_FALSE(patch(twin).twin);

    design = start;
    apply(unlinkTwins(design, std::array{side}));
    EXPECT_EQ(twinOf(design, side), noElement);
    EXPECT_NE(twinOf(design, rail), noElement);
    apply(movePatchPoints(design, side, std::array{4}, Vec2(5, 7)));
    EXPECT_EQ(point(twin, 4), Vec2(-95, 130));
    EXPECT_TRUE(unlinkTwins(design, std::array{side}).empty());

    design = start;
    const Edit copy = addElement(design, design.element(twin));
    apply(copy);
    EXPECT_FALSE(patch(copy.changes.front().id).twin) << "a copy is nobody's twin";
    EXPECT_EQ(twinOf(design, side), twin);
}

// Two pieces that were drawn separately, each from its own corner and counter-clockwise, the second turned.
constexpr const char* drawnDesign = R"({"format": "bolster-design", "version": 1, "unit": "mm", "elements": [
  {"id": 1, "kind": "fabric", "name": "Leather"},
  {"id": 2, "kind": "patch", "name": "A", "fabric": 1,
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[100,0],[150,300],[0,250]]}},
  {"id": 3, "kind": "patch", "name": "B", "fabric": 1, "position": [500, 0],
   "outline": {"degree": 1, "closed": true, "points": [[0,-100],[0,0],[-250,0],[-300.4,-150.2]]}},
  {"id": 4, "kind": "patch", "name": "C", "fabric": 1, "position": [900, 0],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[300,0],[300,40],[0,40]]}},
  {"id": 5, "kind": "seam", "a": {"patch": 2, "from": 3, "to": 0}, "b": {"patch": 3, "from": 1, "to": 2}},
  {"id": 6, "kind": "fixation_curve", "name": "P", "curve": {"degree": 1, "closed": false,
   "points": [[-100,0,0],[-100,300,0]]}},
  {"id": 7, "kind": "fixation_curve", "name": "Q", "curve": {"degree": 1, "closed": false,
   "points": [[101,301,0],[101,0,0]]}},
  {"id": 8, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 7}]})";

TEST_F(TwinsTest, WhatLiesOnOneOfThemAloneComesToBothWhenTheyAreLinked)
{
    design = test::soundDesign(drawnDesign);
    constexpr ElementId a{2}, b{3};
    const auto widths = [&] {
        std::map<ElementId, double> found;
        design.each<EdgeAllowance>(
            [&](ElementId, const EdgeAllowance& edge) { found[edge.stretch.patch] = edge.width; });
        return found;
    };
    apply(setEdgeAllowance(design, {a, 1, 2}, 25));
    apply(linkTwins(design, a, b));
    EXPECT_EQ(widths(), (std::map<ElementId, double>{{a, 25}, {b, 25}}));
    apply(setEdgeAllowance(design, {a, 1, 2}, 30));
    EXPECT_EQ(widths(), (std::map<ElementId, double>{{a, 30}, {b, 30}})) << "they follow each other";
}

TEST_F(TwinsTest, LinksWhatWasDrawnSeparately)
{
    design = test::soundDesign(drawnDesign);
    constexpr ElementId a{2}, b{3}, c{4}, p{6}, q{7};
    Message problem;
    EXPECT_TRUE(linkTwins(design, a, c, &problem).empty());
    EXPECT_NE(problem.english().find("no mirror images"), std::string::npos);
    EXPECT_TRUE(linkTwins(design, a, p, &problem).empty());
    EXPECT_TRUE(linkTwins(design, a, a, &problem).empty());

    // B is A in the mirror, turned by 90 degrees, and its first point is the last corner but one.
    const auto inLayout = [&](double t) { return toLayout(patch(b), patch(b).outline.at(t)); };
    const Vec2 from = inLayout(1);
    const Vec2 to = inLayout(2);
    apply(linkTwins(design, a, b));
    ASSERT_EQ(twinOf(design, a), b);
    EXPECT_EQ(unlike(b), 0);
    EXPECT_EQ(patch(b).name, "B");
    const Seam& seam = *design.find<Seam>(ElementId{5});
    EXPECT_LT((inLayout(seam.b.from) - to).norm(), 1) << "where it was in the layout";
    EXPECT_LT((inLayout(seam.b.to) - from).norm(), 1);
    EXPECT_EQ(seam.b.from, std::round(seam.b.from)) << "at a corner";
    EXPECT_TRUE(linkTwins(design, a, b).empty()) << "they are already";

    apply(linkTwins(design, p, q));
    EXPECT_EQ(design.find<FixationCurve>(q)->curve.points()[0], Vec3(100, 0, 0));
    EXPECT_TRUE(design.find<FixationSeam>(ElementId{8})->reversed);
}

TEST_F(TwinsTest, LinkingLeavesSeamsWhereTheyAre)
{
    // B is A's mirror image; its corners have other numbers.
    design = test::soundDesign(R"({"format": "bolster-design", "version": 1, "unit": "mm", "elements": [
      {"id": 1, "kind": "fabric", "name": "Leather"},
      {"id": 2, "kind": "patch", "name": "A", "fabric": 1,
       "outline": {"degree": 1, "closed": true, "points": [[0,0],[100,0],[150,300],[0,250]]}},
      {"id": 3, "kind": "patch", "name": "B", "fabric": 1, "position": [500, 0],
       "outline": {"degree": 1, "closed": true, "points": [[-100,0],[0,0],[0,250],[-75,275],[-150,300]]}},
      {"id": 4, "kind": "patch", "name": "C", "fabric": 1, "position": [900, 0],
       "outline": {"degree": 1, "closed": true, "points": [[0,0],[100,0],[100,250],[0,250]]}},
      {"id": 5, "kind": "seam", "a": {"patch": 2, "from": 3, "to": 0}, "b": {"patch": 4, "from": 1, "to": 2}},
      {"id": 6, "kind": "seam", "a": {"patch": 3, "from": 1, "to": 2}, "b": {"patch": 4, "from": 3, "to": 0}},
      {"id": 7, "kind": "seam", "a": {"patch": 2, "from": 1, "to": 2}, "b": {"patch": 4, "from": 0, "to": 1}}]})");
    const Seam before = *design.find<Seam>(ElementId{7});
    apply(linkTwins(design, ElementId{2}, ElementId{3}));
    ASSERT_EQ(twinOf(design, ElementId{2}), ElementId{3});
    EXPECT_EQ(*design.find<Seam>(ElementId{7}), before) << "nothing of this one has changed";
    EXPECT_EQ(mirroredElement(design, ElementId{5}), ElementId{6});
}

TEST_F(TwinsTest, LinksByChanceAreDropped)
{
    Patch pasted = patch(twin);
    pasted.twin = Twin{seat, {}};
    const Edit edit = addElement(design, makeElement(pasted));
    apply(edit);
    const Patch& there = patch(edit.changes.front().id);
    EXPECT_FALSE(there.twin);
    EXPECT_EQ(there.outline, pasted.outline);
}

TEST_F(TwinsTest, FollowTheMirror)
{
    Settings settings = design.settings();
    settings.symmetry->planePoint = Vec3(50, 0, 0);
    settings.symmetry->planeNormal = Vec3(-2, 0, 0);
    apply(changeSettings(design, settings));
    EXPECT_EQ(design.find<FixationCurve>(rail)->curve.at(0), Vec3(-300, 0, 0));
    EXPECT_EQ(design.find<FixationCurve>(twinRail)->curve.at(0), Vec3(400, 0, 0));
    settings.symmetry->planeNormal = Vec3(1, 2, -1);
    apply(changeSettings(design, settings));
    apply(moveCurvePoints(design, twinRail, std::array{1}, Vec3(1, 2, 3)));
    EXPECT_EQ(unlike(twinRail), 0);
}

TEST_F(TwinsTest, AreWrittenAndReadBack)
{
    apply(releasePoints(design, side, std::array{4, 5}));
    apply(movePatchPoints(design, side, std::array{5}, Vec2(5, 0)));
    Settings settings = design.settings();
    settings.symmetry->axisPoint = Vec2(10, 0);
    apply(changeSettings(design, settings));
    const std::string text = writeDesign(design);
    EXPECT_NE(text.find(R"("symmetry": {"axis": {"point": [10, 0]}})"), std::string::npos) << text;
    EXPECT_NE(text.find(R"("twin": {"of": 3, "released": [4, 5]})"), std::string::npos) << text;
    EXPECT_TRUE(test::soundDesign(text) == design);
}

struct BadLink {
    const char* twin;
    const char* field;
    const char* message;
};

TEST_F(TwinsTest, SaysWhatIsWrongWithALink)
{
    const std::string good = writeDesign(design);
    const std::string link = R"("twin": {"of": 3})";
    for (const BadLink& bad : {BadLink{R"("twin": {"of": 99})", "twin.of", "cannot be its twin"},
                               BadLink{R"("twin": {"of": 5})", "twin.of", "cannot be its twin"},
                               BadLink{R"("twin": {"of": 3, "released": [12]})", "twin.released", "no point 12"}}) {
        std::string text = good;
        text.replace(text.find(link), link.size(), bad.twin);
        const Problems problems = checkDesign(test::soundDesign(text));
        const auto told = std::find_if(problems.begin(), problems.end(),
                                       [&](const Problem& problem) { return problem.field == bad.field; });
        ASSERT_NE(told, problems.end()) << bad.twin;
        EXPECT_EQ(told->element, twin);
        EXPECT_EQ(told->severity, Severity::Warning) << "the surface does not depend on it";
        EXPECT_NE(told->english().find(bad.message), std::string::npos) << told->english();
    }
    for (const char* broken : {R"("twin": 3)", R"("twin": {})", R"("twin": {"of": 3, "released": []})",
                               R"("twin": {"of": 3, "released": [-1]})"}) {
        std::string text = good;
        text.replace(text.find(link), link.size(), broken);
        const ReadDesign read = readDesign(text);
        EXPECT_TRUE(std::holds_alternative<Quarantined>(*read.design.element(twin))) << broken;
    }
    Patch moved = patch(twin);
    moved.outline = moved.outline.withPoint(2, Vec2(0, -20));
    const Design unlike = design.with({{}, {{twin, nullptr, makeElement(moved)}}});
    const Problems problems = checkDesign(unlike);
    EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), [](const Problem& p) { return p.field == "twin"; }));
}

TEST_F(TwinsTest, StayMirrorImagesWhateverIsDone)
{
    const Design start = design;
    for (unsigned seed = 0; seed < 30; ++seed) {
        design = start;
        test::Random random(seed);
        for (int step = 0; step < 60; ++step) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << ", step " << step);
            const ElementId id = std::array{side, twin}[static_cast<std::size_t>(random.whole(0, 1))];
            const ElementId curve = std::array{rail, twinRail}[static_cast<std::size_t>(random.whole(0, 1))];
            const std::array some = {random.whole(0, patch(id).outline.pointCount() - 1),
                                     random.whole(0, patch(id).outline.pointCount() - 1)};
            const std::array one = {random.whole(0, design.find<FixationCurve>(curve)->curve.pointCount() - 1)};
            switch (random.whole(0, 9)) {
            case 0:
            case 1:
            case 2:
                apply(movePatchPoints(design, id, some, test::randomPoint<2>(random, 20)));
                break;
            case 3:
                apply(insertPatchPoint(design, id, random.real(0, 12)));
                break;
            case 4:
                apply(removePatchPoint(design, id, some[0]));
                break;
            case 5:
                apply(releasePoints(design, id, some));
                break;
            case 6:
                apply(relinkPoints(design, id, releasedPoints(design, id)));
                break;
            case 7:
                apply(moveCurvePoints(design, curve, one, test::randomPoint<3>(random, 20)));
                break;
            case 8:
                apply(insertCurvePoint(design, curve, random.real(0, 2)));
                break;
            default:
                apply(removeCurvePoint(design, curve, one[0]));
            }
            ASSERT_EQ(unlike(twin), 0);
            ASSERT_EQ(unlike(twinRail), 0);
        }
        EXPECT_TRUE(test::soundDesign(writeDesign(design)) == design);
    }
}

} // namespace
} // namespace bolster::twins
