// Shapes and places of patches: scaling, turning, mirroring, corners, layout, copies.
#include "CopyPaste.h"
#include "CornerEdits.h"
#include "DesignCheck.h"
#include "EditBuilder.h"
#include "ElementEdits.h"
#include "LayoutEdits.h"
#include "LengthEdits.h"
#include "PatchShapeEdits.h"

#include "TestData.h"

namespace bolster {
namespace {

using namespace edits;

constexpr const char* twoPatches = R"({"format": "bolster-design", "version": 1, "unit": "mm", "elements": [
  {"id": 1, "kind": "fabric", "name": "Leather"},
  {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1, "position": [10, 20],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[500,0],[500,480],[0,480]]}},
  {"id": 3, "kind": "patch", "name": "Side", "fabric": 1, "position": [600, 0], "rotation": 90,
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[480,0],[480,120],[0,150]]}},
  {"id": 4, "kind": "seam", "a": {"patch": 2, "from": 1, "to": 2}, "b": {"patch": 3, "from": 0, "to": 1}},
  {"id": 5, "kind": "fixation_curve", "name": "Rail",
   "curve": {"degree": 1, "closed": false, "points": [[0,0,0],[500,0,0]]}},
  {"id": 6, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 5},
  {"id": 7, "kind": "fancy_seam", "name": "Pipe", "patch": 2,
   "curve": {"degree": 1, "closed": false, "points": [[100,100],[400,200]]}}]})";

constexpr ElementId leather{1}, seat{2}, side{3}, seam{4}, rail{5}, fixation{6}, pipe{7};

class ShapeEdits : public testing::Test {
protected:
    const Design design = test::soundDesign(twoPatches);

    /// The design after an edit that does something, can be undone and breaks nothing.
    Design after(const Edit& edit) { return after(design, edit); }
    Design after(const Design& before, const Edit& edit)
    {
        EXPECT_FALSE(edit.empty());
        const Design result = before.with(edit);
        EXPECT_EQ(result.with(edit.inverse()), before);
        EXPECT_EQ(readDesign(writeDesign(result)).design, result);
        for (const Problem& problem : checkDesign(result))
            EXPECT_EQ(problem.severity, Severity::Warning) << problem.english();
        return result;
    }
    static Vec2 place(const Design& d, ElementId id, double t)
    {
        const Patch& patch = *d.find<Patch>(id);
        return toLayout(patch, patch.outline.at(t));
    }
};

TEST_F(ShapeEdits, ScalesPatchesWithTheirCurvesInTheLayout)
{
    const Design scaled = after(scalePatches(design, std::vector{seat, side}, Vec2(10, 20), Vec2(2, 0.5)));
    EXPECT_LT((place(scaled, seat, 2) - Vec2(1010, 260)).norm(), 1e-9);
    for (double t = 0; t < 4; t += 0.3) {
        const Vec2 expected = Vec2(10, 20) + (place(design, side, t) - Vec2(10, 20)).cwiseProduct(Vec2(2, 0.5));
        EXPECT_LT((place(scaled, side, t) - expected).norm(), 1e-9) << t;
    }
    EXPECT_EQ(scaled.find<FancySeam>(pipe)->curve.points()[1], Vec2(800, 100));
    EXPECT_EQ(scaled.find<Seam>(seam)->a, design.find<Seam>(seam)->a);
    EXPECT_TRUE(scalePatches(design, std::vector{seat}, Vec2(0, 0), Vec2(1, 1)).empty());
    EXPECT_TRUE(scalePatches(design, std::vector{seat}, Vec2(0, 0), Vec2(-1, 1)).empty());
    EXPECT_TRUE(scalePatches(design, std::vector{seat}, Vec2(0, 0), Vec2(std::nan(""), 1)).empty());
    EXPECT_TRUE(scalePatches(design, std::vector{rail}, Vec2(0, 0), Vec2(2, 2)).empty());
}

TEST_F(ShapeEdits, PatchesTakeAWidthAndAHeight)
{
    Design sized = after(resizePatches(design, std::vector{seat, side}, 0, 300));
    EXPECT_EQ(sized.find<Patch>(seat)->outline.boundingBox().sizes(), Vec2(300, 480));
    const Box2 before = layoutBox(*design.find<Patch>(side)), now = layoutBox(*sized.find<Patch>(side));
    EXPECT_NEAR(now.sizes().x(), 300, 1e-6) << "as it lies, turned or not";
    EXPECT_NEAR(now.sizes().y(), before.sizes().y(), 1e-6);
    EXPECT_LT((now.min() - before.min()).norm(), 1e-6);
    EXPECT_NEAR(sized.find<FancySeam>(pipe)->curve.points()[1].x(), 240, 1e-9);
    sized = after(sized, resizePatches(sized, std::vector{seat}, 1, 600));
    EXPECT_LT((sized.find<Patch>(seat)->outline.boundingBox().sizes() - Vec2(300, 600)).norm(), 1e-9);
    EXPECT_TRUE(resizePatches(design, std::vector{seat}, 0, 0).empty());
    EXPECT_TRUE(resizePatches(design, std::vector{seat}, 0, std::nan("")).empty());
}

TEST_F(ShapeEdits, AnEdgeTakesALengthAboutItsMiddle)
{
    const Design changed = after(setEdgeLengths(design, std::array{Stretch{seat, 0, 1}}, 600));
    EXPECT_LT((changed.find<Patch>(seat)->outline.points()[0] - Vec2(-50, 0)).norm(), 1e-6);
    EXPECT_LT((changed.find<Patch>(seat)->outline.points()[1] - Vec2(550, 0)).norm(), 1e-6);
    EXPECT_EQ(changed.find<Patch>(seat)->outline.points()[2], Vec2(500, 480));
    Message problem;
    EXPECT_TRUE(setEdgeLengths(design, std::array{Stretch{seat, 0.5, 1}}, 600, &problem).empty());
    EXPECT_FALSE(problem.empty()) << "it does not begin at a corner";
    EXPECT_TRUE(setEdgeLengths(design, std::array{Stretch{seat, 0, 1}}, -1).empty());
}

TEST_F(ShapeEdits, EdgesBecomeEquallyLongAndTheFirstOneStays)
{
    // All round one patch, each sharing both its corners, and one of another patch.
    const std::vector<Stretch> edges = {{side, 1, 2}, {side, 2, 3}, {side, 3, 0}, {side, 0, 1}, {seat, 1, 2}};
    const Design changed = after(makeEdgesEqual(design, edges));
    for (const Stretch& edge : edges)
        EXPECT_NEAR(edgeLength(changed, edge), 120, 1e-4);
    EXPECT_EQ(changed.find<Patch>(side)->outline.points()[1], Vec2(480, 0));
    EXPECT_EQ(changed.find<Patch>(side)->outline.points()[2], Vec2(480, 120));
    EXPECT_TRUE(makeEdgesEqual(changed, edges).empty()) << "nothing is left to do";
    EXPECT_TRUE(makeEdgesEqual(design, std::array{Stretch{side, 1, 2}}).empty());
}

TEST_F(ShapeEdits, TheSecondSideOfASeamBecomesAsLongAsTheFirst)
{
    const Design uneven = after(setEdgeLengths(design, std::array{Stretch{seat, 1, 2}}, 510));
    const Design even = after(uneven, makeSeamSidesEqual(uneven, std::array{seam}));
    EXPECT_NEAR(edgeLength(even, {side, 0, 1}), 510, 1e-6);
    EXPECT_NEAR(edgeLength(even, {seat, 1, 2}), 510, 1e-6);
}

TEST_F(ShapeEdits, OfASeamThatEndsInsideAnEdgeTheOtherSideChanges)
{
    Seam part = *design.find<Seam>(seam);
    part.b = {side, 0.25, 1};
    const Design inside = design.with({{}, {{seam, nullptr, makeElement(part)}}});
    const Edit edit = makeSeamSidesEqual(inside, std::array{seam});
    ASSERT_FALSE(edit.empty());
    EXPECT_FALSE(edit.note.empty()) << "which side was changed is said";
    const Design even = inside.with(edit);
    EXPECT_NEAR(edgeLength(even, part.b), edgeLength(inside, part.b), 1e-9);
    EXPECT_NEAR(edgeLength(even, part.a), edgeLength(inside, part.b), 1e-4);
}

TEST_F(ShapeEdits, MirrorsInPlace)
{
    for (const MirrorAxis axis : {MirrorAxis::Vertical, MirrorAxis::Horizontal}) {
        const int across = axis == MirrorAxis::Vertical ? 0 : 1;
        const Edit edit = mirrorPatches(design, std::vector{seat, side}, axis, 300);
        const Design mirrored = after(edit);
        for (const ElementId id : {seat, side})
            for (double t = 0; t < 4; t += 0.3) {
                Vec2 expected = place(design, id, t);
                expected[across] = 600 - expected[across];
                EXPECT_LT((place(mirrored, id, t) - expected).norm(), 1e-9) << t;
            }
        EXPECT_EQ(*mirrored.find<Seam>(seam), *design.find<Seam>(seam)) << "both sides are mirrored";
        EXPECT_FALSE(mirrored.find<Patch>(seat)->wrongSideOut);
        EXPECT_EQ(mirrored.with(mirrorPatches(mirrored, std::vector{seat, side}, axis, 300)), design);
    }
    EXPECT_TRUE(mirrorPatches(design, std::vector{rail}, MirrorAxis::Vertical, 0).empty());
}

TEST_F(ShapeEdits, MirroringOneSideOfASeamTurnsItRound)
{
    const Design mirrored = after(mirrorPatches(design, std::vector{side}, MirrorAxis::Vertical, 0));
    EXPECT_EQ(mirrored.find<Seam>(seam)->reversed, !design.find<Seam>(seam)->reversed);
    EXPECT_EQ(checkDesign(mirrored).size(), checkDesign(design).size()) << "right side still meets right side";
}

TEST_F(ShapeEdits, ASmoothPointLeavesTheOtherEdgesStraight)
{
    const Design smooth = after(makeSmooth(design, seat, std::vector{2}));
    const BSpline2& before = design.find<Patch>(seat)->outline;
    const BSpline2& outline = smooth.find<Patch>(seat)->outline;
    EXPECT_EQ(outline.degree(), 3);
    EXPECT_EQ(outline.pointCount(), 10);
    EXPECT_EQ(outline.corners(), (std::vector<double>{0, 1, 3}));
    for (const double t : {0.0, 0.2, 0.9, 1.0, 3.0, 3.4, 3.99})
        EXPECT_LT((outline.at(t) - before.at(t)).norm(), 1e-10) << t;
    EXPECT_LT((outline.points()[static_cast<std::size_t>(outline.pointAt(2))] - Vec2(500, 480)).norm(), 1e-9);
    EXPECT_GT((outline.at(2) - before.at(2)).norm(), 5) << "rounded";
    EXPECT_LT((outline.derivative(2 - 1e-9) - outline.derivative(2)).norm(), 1e-3);
    EXPECT_EQ(smooth.find<Seam>(seam)->a, design.find<Seam>(seam)->a);

    const Design again = after(smooth, makeCorners(smooth, seat, std::vector{outline.pointAt(2)}));
    const BSpline2& cornered = again.find<Patch>(seat)->outline;
    EXPECT_EQ(cornered.corners(), (std::vector<double>{0, 1, 2, 3}));
    EXPECT_LT((cornered.at(2) - Vec2(500, 480)).norm(), 1e-9) << "the point stays where it is";
    EXPECT_TRUE(makeCorners(design, seat, std::vector{2}).empty()) << "a polygon has corners everywhere";
    EXPECT_TRUE(makeSmooth(smooth, seat, std::vector{outline.pointAt(2)}).empty());
    EXPECT_TRUE(makeSmooth(design, rail, std::vector{1}).empty());
    EXPECT_TRUE(makeSmooth(design, seat, std::vector{-1, 17}).empty());
}

TEST_F(ShapeEdits, AnyPointsCanBeMadeSmoothAndCornersAgain)
{
    for (int chosen = 1; chosen < 16; ++chosen) {
        std::vector<int> points;
        for (int i = 0; i < 4; ++i)
            if (chosen >> i & 1)
                points.push_back(i);
        const Design smooth = after(makeSmooth(design, seat, points));
        const BSpline2& outline = smooth.find<Patch>(seat)->outline;
        EXPECT_EQ(outline.pointCount(), 12 - 2 * static_cast<int>(points.size()));
        EXPECT_EQ(outline.domainStart(), 0);
        EXPECT_EQ(outline.period(), 4);
        std::vector<int> again;
        for (const int i : points) {
            const int now = outline.pointAt(i);
            EXPECT_FALSE(isCornerPoint(smooth, seat, now));
            EXPECT_LT((outline.points()[static_cast<std::size_t>(now)] -
                       design.find<Patch>(seat)->outline.points()[static_cast<std::size_t>(i)])
                          .norm(),
                      1e-9);
            again.push_back(now);
        }
        const Design cornered = after(smooth, makeCorners(smooth, seat, again));
        EXPECT_EQ(cornered.find<Patch>(seat)->outline.corners().size(), 4u);
    }
}

TEST_F(ShapeEdits, SmoothsCurvesDrawnInPatches)
{
    EXPECT_TRUE(makeSmooth(design, pipe, std::vector{0, 1}).empty()) << "ends stay ends";
    const BSpline2 bent(1, false, {{100, 100}, {250, 300}, {400, 200}});
    const Design longer =
        design.with(replaceElement(design, pipe, withPlaneCurve(*design.element(pipe), bent), {"x"}));
    const Design smooth = after(longer, makeSmooth(longer, pipe, std::vector{1}));
    const BSpline2& curve = smooth.find<FancySeam>(pipe)->curve;
    EXPECT_EQ(curve.pointCount(), 5);
    EXPECT_TRUE(curve.corners().empty());
    EXPECT_EQ(curve.points().front(), Vec2(100, 100));
    EXPECT_EQ(curve.points()[2], Vec2(250, 300));
}

TEST_F(ShapeEdits, StraightensTheShorterWay)
{
    const BSpline2 wavy(1, true, {{0, 0}, {100, 30}, {300, -30}, {500, 0}, {500, 480}, {0, 480}});
    const Design waves =
        design.with(replaceElement(design, seat, withPlaneCurve(*design.element(seat), wavy), {"x"}));
    const Design straight = after(waves, straighten(waves, seat, 3, 0));
    const auto& points = straight.find<Patch>(seat)->outline.points();
    EXPECT_EQ(points.size(), 6u);
    EXPECT_EQ(points[0], Vec2(0, 0));
    EXPECT_EQ(points[4], Vec2(500, 480));
    EXPECT_NEAR(points[1].y(), 0, 1e-9);
    EXPECT_NEAR(points[2].y(), 0, 1e-9);
    EXPECT_LT(points[1].x(), points[2].x());
    EXPECT_TRUE(straighten(waves, seat, 0, 0).empty());
    EXPECT_TRUE(straighten(waves, seat, 0, 9).empty());
    EXPECT_TRUE(straighten(design, seat, 0, 1).empty()) << "it is straight";
    const BSpline2 flat(1, true, {{0, 0}, {0, 0}, {0, 0}, {500, 480}});
    const Design bad =
        design.with(replaceElement(design, seat, withPlaneCurve(*design.element(seat), flat), {"x"}));
    EXPECT_TRUE(straighten(bad, seat, 0, 2).empty());
}

TEST_F(ShapeEdits, StraightensSplinesExactly)
{
    std::vector<Vec2> round;
    for (int i = 0; i < 10; ++i)
        round.emplace_back(200 * std::cos(0.2 * M_PI * i), 200 * std::sin(0.2 * M_PI * i));
    const Design smooth = design.with(
        replaceElement(design, seat, withPlaneCurve(*design.element(seat), BSpline2(3, true, round)), {"x"}));
    const Design straight = after(smooth, straighten(smooth, seat, 8, 1)); // passes the start
    const BSpline2& outline = straight.find<Patch>(seat)->outline;
    const Vec2 from = round[8], to = round[1];
    EXPECT_LT((outline.at(8) - from).norm(), 1e-9);
    EXPECT_LT((outline.at(1) - to).norm(), 1e-9);
    for (const double t : {8.3, 9.0, 9.7, 10.2, 10.8})
        EXPECT_LT((outline.at(std::fmod(t, 10)) - (from + (t - 8) / 3 * (to - from))).norm(), 1e-9) << t;
    EXPECT_LT((outline.at(5) - BSpline2(3, true, round).at(5)).norm(), 1e-9) << "the rest stays";
}

TEST_F(ShapeEdits, AlignsAndDistributes)
{
    const std::vector<ElementId> both = {seat, side};
    const auto box = [](const Design& d, ElementId id) { return layoutBox(*d.find<Patch>(id)); };
    EXPECT_LT((box(design, side).min() - Vec2(450, 0)).norm(), 1e-9);
    EXPECT_NEAR(box(after(alignPatches(design, both, Alignment::Left)), side).min().x(), 10, 1e-9);
    EXPECT_NEAR(box(after(alignPatches(design, both, Alignment::Right)), seat).max().x(), 600, 1e-9);
    EXPECT_NEAR(box(after(alignPatches(design, both, Alignment::Top)), side).max().y(), 500, 1e-9);
    EXPECT_NEAR(box(after(alignPatches(design, both, Alignment::Bottom)), seat).min().y(), 0, 1e-9);
    const Design centred = after(alignPatches(design, both, Alignment::CentreX));
    EXPECT_NEAR(box(centred, seat).center().x(), box(centred, side).center().x(), 1e-9);
    EXPECT_TRUE(alignPatches(design, std::vector{seat}, Alignment::Left).empty());
    EXPECT_TRUE(distributePatches(design, both, Direction::Horizontal).empty());

    const Design three = design.with(duplicatePatches(design, std::vector{side}, Vec2(1000, 300)));
    const std::vector<ElementId> all = {seat, side, three.elements().rbegin()->first};
    const Design even = after(three, distributePatches(three, all, Direction::Horizontal));
    EXPECT_EQ(box(even, all[0]).min(), box(three, all[0]).min());
    EXPECT_EQ(box(even, all[2]).min(), box(three, all[2]).min());
    EXPECT_NEAR(box(even, all[1]).min().x() - box(even, all[0]).max().x(),
                box(even, all[2]).min().x() - box(even, all[1]).max().x(), 1e-9);
}

TEST_F(ShapeEdits, ArrangesWithoutOverlap)
{
    for (const char* name : test::designNames) {
        const Design seatDesign = test::soundDesign(test::designText(name));
        const Edit edit = arrangePatches(seatDesign, {}, 30);
        const Design arranged = seatDesign.with(edit);
        EXPECT_EQ(arranged.with(edit.inverse()), seatDesign);
        std::vector<Box2> boxes;
        arranged.each<Patch>([&](ElementId, const Patch& patch) { boxes.push_back(layoutBox(patch)); });
        for (std::size_t i = 0; i < boxes.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_GT(boxes[i].exteriorDistance(boxes[j]), 29.99) << name << " " << i << " " << j;
        EXPECT_TRUE(arrangePatches(arranged, {}, 30).empty()) << "nothing is left to do";
    }
}

TEST_F(ShapeEdits, DuplicatesWithCurvesAndSeams)
{
    const Edit edit = duplicatePatches(design, std::vector{seat, side}, Vec2(50, -60));
    const Design more = after(edit);
    const std::vector<ElementId> added = addedPieces(edit);
    ASSERT_EQ(added.size(), 2u);
    EXPECT_EQ(more.elements().size(), design.elements().size() + 4) << "two patches, a seam and a fancy seam";
    EXPECT_EQ(more.find<Patch>(added[0])->name, "Seat 2");
    EXPECT_EQ(more.find<Patch>(added[0])->position, Vec2(60, -40));
    EXPECT_EQ(more.find<Patch>(added[0])->fabric, leather);
    int seams = 0;
    more.each<Seam>([&](ElementId, const Seam& s) { seams += s.a.patch == added[0] && s.b.patch == added[1]; });
    EXPECT_EQ(seams, 1);
    const Edit third = duplicatePatches(more, std::vector{added[0]}, Vec2(1, 1));
    EXPECT_EQ(std::get<Patch>(*third.changes.front().after).name, "Seat 3");
    EXPECT_TRUE(duplicatePatches(design, std::vector{seam, leather}, Vec2(1, 1)).empty());
}

TEST_F(ShapeEdits, CopiesAreCompleteDesigns)
{
    EXPECT_TRUE(copyText(design, std::vector{seam, leather}).empty());
    const std::string text = copyText(design, std::vector{seat, rail});
    const Design part = test::soundDesign(text);
    EXPECT_EQ(part.elements().size(), 5u) << "fabric, patch, curve, fixation seam, fancy seam";
    EXPECT_FALSE(part.element(side));

    const Outcome pasted = paste(Design(), text, Vec2(5, 0));
    EXPECT_TRUE(pasted.problem.empty());
    const Design elsewhere = after(Design(), pasted.edit);
    EXPECT_EQ(elsewhere.elements().size(), 5u);
    const Outcome again = paste(elsewhere, text, Vec2(5, 0));
    EXPECT_EQ(after(elsewhere, again.edit).elements().size(), 9u) << "the fabric is there already";
    EXPECT_EQ(addedPieces(again.edit).size(), 2u);
}

TEST_F(ShapeEdits, PastingNonsenseIsRefused)
{
    for (const char* text : {"", "hello", "{}", R"({"format": "bolster-design", "version": 1, "elements": []})"}) {
        const Outcome outcome = paste(design, text, Vec2(0, 0));
        EXPECT_TRUE(outcome.edit.empty()) << text;
        EXPECT_FALSE(outcome.problem.empty()) << text;
    }
}

TEST(LengthEdits, AStraightEdgeKeepsItsDirection)
{
    Edit edit;
    Patch patch;
    patch.name = "Kite";
    patch.outline = BSpline2(1, true, {{0, 0}, {30, 40}, {60, 100}, {0, 100}});
    HandleCurve handle{{"Ridge", ElementId{2}, BSpline2(3, false, {{5, 50}, {10, 70}, {20, 60}, {25, 80}})}, {}};
    edit.changes = {{ElementId{2}, nullptr, makeElement(patch)}, {ElementId{3}, nullptr, makeElement(handle)}};
    const Design design = Design().with(edit);

    EXPECT_NEAR(edits::lengthBetween(design, ElementId{2}, 1, 0), 50, 1e-9);
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 0)}) {
        const Edit longer = edits::setLengthBetween(design, ElementId{2}, a, b, 75);
        EXPECT_EQ(longer.verb.english(), "Change the length of a stretch of Kite");
        const auto& points = design.with(longer).find<Patch>(ElementId{2})->outline.points();
        EXPECT_LT((points[1] - Vec2(45, 60)).norm(), 1e-6) << "the end moves, the start stays";
        EXPECT_EQ(points[2], Vec2(60, 100));
        EXPECT_EQ(design.with(longer).with(longer.inverse()), design);
    }
    EXPECT_TRUE(edits::setLengthBetween(design, ElementId{2}, 0, 1, 50).empty()) << "it is so long";
    EXPECT_TRUE(edits::setLengthBetween(design, ElementId{2}, 0, 0, 10).empty());
    EXPECT_TRUE(edits::setLengthBetween(design, ElementId{2}, 0, 7, 10).empty());
    EXPECT_TRUE(edits::setLengthBetween(design, ElementId{2}, 0, 1, 0).empty());
    EXPECT_TRUE(edits::setLengthBetween(design, ElementId{9}, 0, 1, 10).empty());

    const double before = edits::lengthBetween(design, ElementId{3}, 0, 3);
    const Edit doubled = edits::setLengthBetween(design, ElementId{3}, 0, 3, 2 * before);
    const auto& curve = design.with(doubled).find<HandleCurve>(ElementId{3})->curve;
    EXPECT_LT((curve.points()[3] - Vec2(45, 110)).norm(), 1e-6) << "scaled about its start";
    EXPECT_NEAR(edits::lengthBetween(design.with(doubled), ElementId{3}, 0, 3), 2 * before, 1e-6);
}

TEST(LengthEdits, ASmoothOutlineReachesTheLength)
{
    Patch patch;
    patch.outline = BSpline2(3, true, {{0, 0}, {100, -20}, {140, 60}, {80, 120}, {-10, 90}});
    const Design design = Design().with({{}, {{ElementId{2}, nullptr, makeElement(patch)}}});
    for (const double length : {60.0, 100.0, 180.0}) {
        const Edit edit = edits::setLengthBetween(design, ElementId{2}, 1, 3, length);
        ASSERT_FALSE(edit.empty()) << length;
        EXPECT_NEAR(edits::lengthBetween(design.with(edit), ElementId{2}, 1, 3), length, 1e-5);
    }
}

/// They followed whatever had the original's number in the design that they came to.
TEST(CopyPaste, CopiesOfTwinsAreEachOthers)
{
    const Design twins = test::soundDesign(R"({"format": "bolster-design", "version": 1, "unit": "mm", "elements": [
  {"id": 1, "kind": "fabric", "name": "Leather"},
  {"id": 2, "kind": "patch", "name": "Left", "fabric": 1,
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[100,0],[100,50],[0,50]]}},
  {"id": 3, "kind": "patch", "name": "Right", "fabric": 1, "twin": {"of": 2},
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[-100,0],[-100,50],[0,50]]}}]})");
    constexpr ElementId original{2}, follower{3};
    for (int others : {0, 5}) {
        EditBuilder there{Design()};
        for (int k = 0; k < others; ++k)
            there.add(Fabric{.name = "Other"});
        const Design before = there.now();
        const Outcome both = paste(before, copyText(twins, std::vector{original, follower}), Vec2(0, 0));
        const Design now = before.with(both.edit);
        int following = 0;
        now.each<Patch>([&](ElementId id, const Patch& patch) {
            if (!patch.twin)
                return;
            ++following;
            EXPECT_NE(patch.twin->of, id);
            EXPECT_TRUE(now.find<Patch>(patch.twin->of)) << others;
        });
        EXPECT_EQ(following, 1) << others;
        const Outcome alone = paste(before, copyText(twins, std::vector{follower}), Vec2(0, 0));
        before.with(alone.edit).each<Patch>([&](ElementId, const Patch& patch) {
            EXPECT_FALSE(patch.twin) << "that of one alone is nobody's";
        });
    }
}

} // namespace
} // namespace bolster
