// What was snapped to an outline keeps its place on it, whatever becomes of the outline.
#include "CornerEdits.h"
#include "EditCheck.h"
#include "FollowEdits.h"
#include "LengthEdits.h"
#include "PatchEdits.h"
#include "PatchMerge.h"
#include "PatchShapeEdits.h"
#include "PatchSplit.h"
#include "TwinEdits.h"
#include "Twins.h"
#include "VersionEdits.h"

#include "TestData.h"

#include "Random.h"

namespace bolster {
namespace {

using namespace edits;

constexpr const char* seatWithCurves = R"({"format": "bolster-design", "version": 1, "unit": "mm", "elements": [
  {"id": 1, "kind": "fabric", "name": "Leather"},
  {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1, "position": [10, 20],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[500,0],[500,400],[0,400]]}},
  {"id": 3, "kind": "patch", "name": "Side", "fabric": 1, "position": [600, 100], "rotation": 90,
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[400,0],[400,120],[0,120]]}},
  {"id": 4, "kind": "seam", "a": {"patch": 2, "from": 1, "to": 2}, "b": {"patch": 3, "from": 0, "to": 1}},
  {"id": 7, "kind": "fancy_seam", "name": "Pipe", "patch": 2,
   "curve": {"degree": 1, "closed": false, "points": [[100,0],[120,200],[100,400]]}},
  {"id": 8, "kind": "handle_curve", "name": "Lumbar", "patch": 2,
   "curve": {"degree": 3, "closed": false, "points": [[0,300],[100,300],[200,300],[300,300]]},
   "target": {"degree": 1, "closed": false, "points": [[0,300,40],[300,300,40]]}},
  {"id": 9, "kind": "fancy_seam", "name": "Free", "patch": 2,
   "curve": {"degree": 1, "closed": false, "points": [[300,1],[300,200]]}},
  {"id": 10, "kind": "fancy_seam", "name": "Rib", "patch": 3,
   "curve": {"degree": 1, "closed": false, "points": [[200,0],[300,120]]}}]})";

class FollowOutline : public testing::Test {
protected:
    static constexpr ElementId seat{2}, side{3}, seam{4}, pipe{7}, lumbar{8}, freeSeam{9}, rib{10};
    Design design = test::soundDesign(seatWithCurves);

    void apply(const Edit& edit)
    {
        ASSERT_FALSE(edit.empty());
        const Edit whole = withFollowers(design, edit);
        const Design after = design.with(whole);
        ASSERT_EQ(after.with(editBetween(design, after, {}).inverse()), design);
        ASSERT_EQ(design.with(withFollowers(design, whole)), after) << "once is enough";
        design = after;
    }
    const BSpline2& outline(ElementId id) const { return design.find<Patch>(id)->outline; }
    const BSpline2& curve(ElementId id) const { return patchCurve(*design.element(id))->curve; }
    Vec2 end(ElementId id, bool last) const
    {
        return last ? curve(id).points().back() : curve(id).points().front();
    }
    /// How far the end is from where it was on the outline.
    double off(ElementId id, bool last, double parameter) const
    {
        const ElementId patch = patchCurve(*design.element(id))->patch;
        return (end(id, last) - outline(patch).at(parameter)).norm();
    }
};

TEST_F(FollowOutline, EndsFollowAnEdgeThatIsDragged)
{
    apply(movePatchPoints(design, seat, std::array{2, 3}, Vec2(0, 60)));
    EXPECT_LT((end(pipe, true) - Vec2(100, 460)).norm(), 1e-9);
    EXPECT_EQ(end(pipe, false), Vec2(100, 0)) << "that edge stayed";
    EXPECT_EQ(curve(pipe).points()[1], Vec2(120, 200)) << "it lies inside";
    EXPECT_EQ(end(freeSeam, false), Vec2(300, 1)) << "1 mm off was meant so";

    apply(movePatchPoints(design, seat, std::array{0}, Vec2(-80, 40)));
    EXPECT_LT(off(pipe, false, 0.2), 1e-9) << "a fifth of the way, as the end of a seam would be";
    EXPECT_LT(off(lumbar, false, 3.25), 1e-9);
}

TEST_F(FollowOutline, WhatIsStraightAtTheEndStaysStraight)
{
    apply(movePatchPoints(design, seat, std::array{0, 3}, Vec2(-90, 30)));
    const std::vector<Vec2>& points = curve(lumbar).points();
    EXPECT_LT((points[0] - Vec2(-90, 330)).norm(), 1e-9);
    EXPECT_EQ(points[3], Vec2(300, 300));
    for (const Vec2& point : points) {
        const Vec2 along = points[3] - points[0], way = point - points[0];
        EXPECT_NEAR(along.x() * way.y() - along.y() * way.x(), 0, 1e-6);
    }
}

TEST_F(FollowOutline, PointsThatTheEditMovesGoWhereItSays)
{
    Edit edit = movePatchPoints(design, seat, std::array{2, 3}, Vec2(0, 60));
    const Edit own = movePatchPoints(design.with(edit), pipe, std::array{2}, Vec2(0, 10));
    edit.changes.push_back(own.changes.front());
    apply(edit);
    EXPECT_EQ(end(pipe, true), Vec2(100, 410));
}

TEST_F(FollowOutline, LengthsAndScaling)
{
    apply(setLengthBetween(design, seat, 2, 3, 700));
    EXPECT_LT(off(pipe, true, 2.8), 1e-9);
    apply(movePatchPoints(design, seat, std::array{1}, Vec2(150, 0)));
    EXPECT_LT(off(pipe, false, 0.2), 1e-9);
    apply(movePatchPoints(design, seat, std::array{2}, Vec2(-5, 50)));
    apply(movePatchPoints(design, seat, std::array{3}, Vec2(5, -50)));
    EXPECT_LT(off(pipe, true, 2.8), 1e-9);
    EXPECT_LT(off(lumbar, false, 3.25), 1e-9);
    apply(scalePatches(design, std::array{seat}, Vec2(5, 5), Vec2(2, 0.5)));
    EXPECT_LT(off(pipe, true, 2.8), 1e-9);
    apply(mirrorPatches(design, std::array{seat}, MirrorAxis::Vertical, 0));
    EXPECT_LT(off(pipe, true, 2.8), 1e-9);
    EXPECT_LT(off(lumbar, false, 3.25), 1e-9);
}

TEST_F(FollowOutline, PointsThatComeAndGoOnTheOutline)
{
    apply(insertPatchPoint(design, seat, 0.5));
    EXPECT_EQ(end(pipe, false), Vec2(100, 0));
    apply(movePatchPoints(design, seat, std::array{1}, Vec2(0, -50)));
    EXPECT_LT((end(pipe, false) - Vec2(100, -20)).norm(), 1e-9);
    apply(removePatchPoint(design, seat, 1));
    EXPECT_NEAR(end(pipe, false).y(), 0, 1e-9);
    apply(makeSmooth(design, seat, std::array{0, 1}));
    EXPECT_LT(outline(seat).closest(end(pipe, false)).distance, 1e-9);
    EXPECT_LT(outline(seat).closest(end(lumbar, false)).distance, 1e-9);
}

TEST_F(FollowOutline, SplittingKeepsWhatLiesOnBothPieces)
{
    const Edit split = splitPatch(design, seat, {Vec2(-20, 220), Vec2(600, 240)}).edit;
    apply(split);
    EXPECT_EQ(curve(pipe).points()[0], Vec2(100, 0)) << "nothing has moved";
    EXPECT_EQ(curve(lumbar).points()[0], Vec2(0, 300));
    const ElementId piece = patchCurve(*design.element(lumbar))->patch;
    const double t = outline(piece).closest(end(lumbar, false)).parameter;
    std::vector<int> all(static_cast<std::size_t>(outline(piece).pointCount()));
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = static_cast<int>(i);
    apply(movePatchPoints(design, piece, all, Vec2(-7, 3)));
    EXPECT_LT(off(lumbar, false, t), 1e-9) << "on the piece, too";
}

TEST_F(FollowOutline, MergingKeepsWhatLiesOnTheOutline)
{
    const Vec2 before = end(rib, true);
    apply(
        movePatchPoints(design, side, std::array{1}, Vec2(8, 0))); // the sides of the seam differ: the joint bends
    ASSERT_EQ(end(rib, true), before);
    apply(mergePatches(design, seam).edit);
    EXPECT_EQ(patchCurve(*design.element(rib))->patch, seat);
    EXPECT_LT(outline(seat).closest(end(rib, true)).distance, 1e-9);
    EXPECT_LT(outline(seat).closest(end(pipe, false)).distance, 1e-9);
    EXPECT_LT(outline(seat).closest(end(pipe, true)).distance, 1e-9);
    EXPECT_LT(outline(seat).closest(end(lumbar, false)).distance, 1e-9);
}

TEST_F(FollowOutline, TwinsAndWhatIsDrawnOnlyOnOneOfThem)
{
    apply(makeTwins(design, std::array{seat}, [](const std::string& name) { return name + " R"; }));
    const ElementId twin = twinOf(design, seat), twinPipe = twinOf(design, pipe);
    ASSERT_NE(twinPipe, noElement);
    apply(unlinkTwins(design, std::array{lumbar}));
    ElementId lone = noElement;
    design.each<HandleCurve>([&](ElementId id, const HandleCurve& h) { lone = h.patch == twin ? id : lone; });
    ASSERT_NE(lone, noElement);

    apply(movePatchPoints(design, seat, std::array{2, 3}, Vec2(-20, 60)));
    EXPECT_LT(off(pipe, true, 2.8), 1e-9);
    EXPECT_LT(off(twinPipe, true, 2.8), 1e-9);
    EXPECT_LT(off(lone, false, 3.25), 1e-9) << "it follows the outline that follows";
    apply(movePatchPoints(design, twin, std::array{0}, Vec2(15, -40)));
    EXPECT_LT(off(pipe, false, 0.2), 1e-9);
    EXPECT_LT(off(twinPipe, false, 0.2), 1e-9);
    EXPECT_LT(off(lone, false, 3.25), 1e-9);
    EXPECT_EQ(unlikePoints(*design.element(pipe), *design.element(twinPipe), symmetryOf(design)), 0);
}

TEST_F(FollowOutline, LinkingTwinsLeavesWhatLiesOnTheOutlineOnIt)
{
    // The follower begins at another corner and is a little larger.
    Patch other = *design.find<Patch>(seat);
    other.twin.reset();
    other.name = "Drawn";
    other.outline = BSpline2(1, true, {{506, 0}, {506, 404}, {0, 404}, {0, 0}});
    FancySeam drawn = *design.find<FancySeam>(pipe);
    drawn.patch = ElementId{20};
    drawn.curve = BSpline2(1, false, {{406, 0}, {406, 404}});
    design = design.with(
        {{}, {{ElementId{20}, nullptr, makeElement(other)}, {ElementId{21}, nullptr, makeElement(drawn)}}});
    apply(linkTwins(design, seat, ElementId{20}));
    for (const bool last : {false, true})
        EXPECT_LT(outline(ElementId{20}).closest(end(ElementId{21}, last)).distance, 1e-9);
}

TEST_F(FollowOutline, AnotherVersionIsTakenAsItWas)
{
    const Design then = design;
    apply(movePatchPoints(design, seat, std::array{2, 3}, Vec2(0, 60)));
    apply(takeFrom(design, then, {seat}));
    EXPECT_EQ(curve(pipe), patchCurve(*then.element(pipe))->curve);
    EXPECT_EQ(outline(seat), then.find<Patch>(seat)->outline);
}

TEST_F(FollowOutline, ADragThatCarriesTheEndsBreaksNothing)
{
    const Edit edit = withFollowers(design, movePatchPoints(design, seat, std::array{0, 3}, Vec2(60, 0)));
    EXPECT_FALSE(brokenBy(design, edit)) << "the handle begins on the edge as before";
}

/// Whatever is done to the outlines of real designs: what lay on them lies on them.
TEST(FollowOutlines, HoldAfterRandomEdits)
{
    for (const char* name : test::designNames)
        for (unsigned seed = 0; seed < 6; ++seed) {
            Design design = test::soundDesign(test::designText(name));
            test::Random random(seed);
            std::vector<ElementId> patches;
            design.each<Patch>([&](ElementId id, const Patch&) { patches.push_back(id); });
            const ElementId patch =
                patches[static_cast<std::size_t>(random.whole(0, static_cast<int>(patches.size()) - 1))];
            FancySeam seamAcross;
            seamAcross.patch = patch;
            const BSpline2 start = design.find<Patch>(patch)->outline;
            const double from = random.real(start.domainStart(), start.domainEnd());
            const double to = start.wrapped(from + 0.4 * start.period());
            seamAcross.curve = BSpline2(1, false, {start.at(from), start.at(to)});
            const ElementId id = design.nextId();
            design = design.with({{}, {{id, nullptr, makeElement(seamAcross)}}});
            for (int step = 0; step < 25; ++step) {
                const int count = design.find<Patch>(patch)->outline.pointCount();
                const std::array some = {random.whole(0, count - 1), random.whole(0, count - 1)};
                const BSpline2& now = design.find<Patch>(patch)->outline;
                Edit edit;
                switch (random.whole(0, 3)) {
                case 0:
                    edit = insertPatchPoint(design, patch, random.real(now.domainStart(), now.domainEnd()));
                    break;
                case 1:
                    edit = removePatchPoint(design, patch, some[0]);
                    break;
                case 2:
                    edit = setLengthBetween(design, patch, some[0], some[1], random.real(50, 400));
                    break;
                default:
                    edit = movePatchPoints(design, patch, some, test::randomPoint<2>(random, 15));
                }
                if (edit.empty())
                    continue;
                design = design.with(withFollowers(design, edit));
                const BSpline2& outline = design.find<Patch>(patch)->outline;
                const BSpline2& curve = design.find<FancySeam>(id)->curve;
                for (const auto& [end, t] : {std::pair(curve.points().front(), from), {curve.points().back(), to}})
                    ASSERT_LT((end - outline.at(outline.wrapped(t))).norm(), 0.01 * (step + 1))
                        << name << " seed " << seed << " step " << step << ": " << edit.verb.english();
            }
        }
}

} // namespace
} // namespace bolster
