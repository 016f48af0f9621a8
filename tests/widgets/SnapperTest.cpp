#include "Snapper.h"

#include "TestDesigns.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bolster {
namespace {

using HintKind = SnapHint::Kind;

/// Two squares of 100 mm: from (0, 0) and from (200, 0). A millimetre is two pixels wide.
class SnapperTest : public testing::Test {
protected:
    SnapperTest()
    {
        scene.reset(twoSquares());
        Box2 box(Vec2(-50, -50));
        box.extend(Vec2(350, 150));
        transform = PatternTransform::fitting(box, {800, 400}, 0);
        settings.on = true;
    }

    Snapped snap(const Vec2& at) const { return snap(SnapQuery{at}); }
    Snapped snap(const SnapQuery& query) const { return Snapper(scene, transform, settings).snap(query); }

    static bool has(const Snapped& snapped, HintKind kind)
    {
        return std::ranges::any_of(snapped.hints, [kind](const SnapHint& hint) { return hint.kind == kind; });
    }

    PatternScene scene;
    PatternTransform transform;
    SnapSettings settings;
};

TEST_F(SnapperTest, CornersBeforeMidpointsBeforeOutlines)
{
    const Snapped corner = snap(Vec2(97, 2));
    EXPECT_EQ(corner.point, Vec2(100, 0));
    EXPECT_TRUE(has(corner, HintKind::Point));
    const Snapped middle = snap(Vec2(51.5, 1));
    EXPECT_LT((middle.point - Vec2(50, 0)).norm(), 1e-9);
    EXPECT_TRUE(has(middle, HintKind::Midpoint));
    const Snapped outline = snap(Vec2(30.3, 1));
    EXPECT_LT((outline.point - Vec2(30.3, 0)).norm(), 1e-9);
    EXPECT_TRUE(has(outline, HintKind::Outline));
}

TEST_F(SnapperTest, NothingNearNothingSnapsNorWhenItIsOff)
{
    const Vec2 free(150, 40);
    EXPECT_EQ(snap(free).point, free);
    EXPECT_TRUE(snap(free).hints.empty());
    settings.on = false;
    EXPECT_EQ(snap(Vec2(99, 1)).point, Vec2(99, 1));
}

TEST_F(SnapperTest, AlignsWithOtherPoints)
{
    SnapQuery query{Vec2(151, 42)};
    query.own = {{152, 130}};
    const Snapped one = snap(query);
    EXPECT_LT((one.point - Vec2(152, 42)).norm(), 1e-9);
    ASSERT_TRUE(has(one, HintKind::Alignment));
    EXPECT_EQ(one.hints.front().from, Vec2(152, 130)) << "where the guide line comes from";
    query.at = {151, 99};
    EXPECT_LT((snap(query).point - Vec2(152, 100)).norm(), 1e-9) << "with two points at once";
}

TEST_F(SnapperTest, KeepsToDirectionsOfTheEdge)
{
    SnapQuery query{Vec2(171, 59)};
    query.from = Vec2(140, 30);
    const Snapped diagonal = snap(query);
    EXPECT_NEAR(diagonal.point.x() - 140, diagonal.point.y() - 30, 1e-9);
    ASSERT_TRUE(has(diagonal, HintKind::Direction));
    EXPECT_NEAR(diagonal.hints.front().value, 45, 1e-9);
    query.at = {141, 60};
    EXPECT_NEAR(snap(query).point.x(), 140, 1e-9);
}

TEST_F(SnapperTest, FindsThePerpendicularOfTheEdgeBefore)
{
    SnapQuery query;
    query.before = Vec2(120, 20);
    query.from = Vec2(150, 30); // along (3, 1)
    query.at = Vec2(143, 54);   // nearly along (-1, 3)
    const Snapped found = snap(query);
    ASSERT_TRUE(has(found, HintKind::Perpendicular));
    EXPECT_NEAR((found.point - *query.from).dot(*query.from - *query.before), 0, 1e-9);
}

TEST_F(SnapperTest, FindsTheLengthOfAnotherEdge)
{
    SnapQuery query;
    query.from = Vec2(150, -40);
    query.at = *query.from + 99 * Vec2(-0.8, 0.6);
    const Snapped found = snap(query);
    ASSERT_TRUE(has(found, HintKind::EqualLength));
    EXPECT_NEAR((found.point - *query.from).norm(), 100, 1e-9) << "as long as an edge of the squares";
}

TEST_F(SnapperTest, TheSidesOfABoxBecomeAsLongAsOthers)
{
    SnapQuery query;
    query.boxFrom = Vec2(-45, -45);
    query.at = *query.boxFrom + Vec2(31, 98);
    const Snapped found = snap(query);
    ASSERT_TRUE(has(found, HintKind::EqualLength));
    EXPECT_NEAR(found.point.y(), 55, 1e-9) << "100 mm high";
    EXPECT_NEAR(found.point.x(), -14, 1e-9);
}

TEST_F(SnapperTest, ADraggedCornerMakesItsEdgesAsLongAsOthers)
{
    SnapQuery query;
    query.ignoredPoints = {{firstSquare, 0}};
    query.lengthsFrom = {Vec2(0, 100), Vec2(100, 0)};
    query.at = Vec2(0, 100) + 101 * Vec2(-0.28, -0.96);
    const Snapped found = snap(query);
    ASSERT_TRUE(has(found, HintKind::EqualLength));
    EXPECT_NEAR((found.point - Vec2(0, 100)).norm(), 100, 1e-9);

    // Its own edges do not count: they are as long as the drag makes them.
    Design design = twoSquares();
    for (const ElementId id : {firstSquare, secondSquare}) {
        Patch patch = *design.find<Patch>(id);
        patch.outline = BSpline2(1, true, {{0, 0}, {70, 0}, {70, 300}, {0, 300}});
        if (id == firstSquare)
            design = design.with({{}, {{id, nullptr, makeElement(patch)}}});
        else
            design = design.with({{}, {{id, nullptr, nullptr}}});
    }
    scene.reset(design);
    query.lengthsFrom = {Vec2(70, 0)};
    query.ignoredPoints = {{firstSquare, 0}};
    query.at = Vec2(1, -5);
    EXPECT_FALSE(has(snap(query), HintKind::EqualLength));
}

TEST_F(SnapperTest, DirectionAndLengthTogether)
{
    SnapQuery query;
    query.from = Vec2(150, 43);
    query.at = Vec2(151, 142);
    const Snapped found = snap(query);
    EXPECT_TRUE(has(found, HintKind::Direction));
    EXPECT_LT((found.point - Vec2(150, 143)).norm(), 1e-6);
}

TEST_F(SnapperTest, MeetsAnOutlineInADirection)
{
    SnapQuery query;
    query.from = Vec2(150, 70);
    query.at = Vec2(101, 71);
    EXPECT_LT((snap(query).point - Vec2(100, 70)).norm(), 1e-6);
}

TEST_F(SnapperTest, GuidesAndGrid)
{
    settings.guides = {{151}, {43}};
    const Snapped crossing = snap(Vec2(150, 42));
    EXPECT_LT((crossing.point - Vec2(151, 43)).norm(), 1e-9);
    EXPECT_TRUE(has(crossing, HintKind::Guide));
    settings.guides = {};
    settings.grid = true;
    const Snapped node = snap(Vec2(149, 41));
    EXPECT_LT((node.point - Vec2(150, 40)).norm(), 1e-9);
    EXPECT_TRUE(has(node, HintKind::Grid));
}

TEST_F(SnapperTest, WhatMovesDoesNotSnapToItself)
{
    SnapQuery query{Vec2(98, 1)};
    query.ignored = {firstSquare, secondSquare};
    EXPECT_EQ(snap(query).point, query.at);
    query.ignored = {};
    query.ignoredPoints = {{firstSquare, 1}};
    EXPECT_FALSE(has(snap(query), HintKind::Point));
}

TEST_F(SnapperTest, MovesThingsOntoPointsOrInLine)
{
    const std::vector<Vec2> corners = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    const Snapper snapper(scene, transform, settings);
    const Snapped onto = snapper.snapMove(corners, {97, 3}, {firstSquare});
    EXPECT_EQ(onto.point, Vec2(100, 0)) << "side by side";
    EXPECT_TRUE(has(onto, HintKind::Point));
    const Snapped inLine = snapper.snapMove(corners, {30, 1}, {firstSquare});
    EXPECT_EQ(inLine.point, Vec2(30, 0));
    EXPECT_TRUE(has(inLine, HintKind::Alignment));
    EXPECT_EQ(snapper.snapMove(corners, {30, 40}, {firstSquare}).point, Vec2(30, 40));
}

} // namespace
} // namespace bolster
