#include "PatternScene.h"
#include "CurvePath.h"
#include "ElementEdits.h"
#include "PatchEdits.h"
#include "SeamColors.h"
#include "TestDesigns.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace bolster {
namespace {

using Kind = PatternHit::Kind;

TEST(CurvePath, RunsThroughTheCurve)
{
    std::vector<Vec2> points;
    for (int i = 0; i < 9; ++i)
        points.emplace_back(100 * std::cos(0.7 * i), 80 * std::sin(0.7 * i));
    const BSpline2 curve = BSpline2::withCorners(points, {0, 4});
    // Beyond the end of the domain and back to its start, as a stretch does that passes it.
    const double from = 6.3;
    const double to = 11.6;
    const QPainterPath path = curvePath(curve, from, to, [](const Vec2& p) { return p; });
    EXPECT_LT((toVec(path.elementAt(0)) - curve.at(from)).norm(), 1e-9);
    EXPECT_LT((toVec(path.currentPosition()) - curve.at(curve.wrapped(to))).norm(), 1e-9);
    for (int i = 0; i <= 200; ++i)
        EXPECT_LT(curve.closest(toVec(path.pointAtPercent(i / 200.0))).distance, 1e-3);
}

TEST(PatternScene, HitsPointsBeforeOutlinesBeforeTheInside)
{
    PatternScene scene;
    scene.reset(twoSquares());
    const auto all = [](ElementId) { return true; };
    const auto none = [](ElementId) { return false; };
    EXPECT_EQ(scene.hit({2, 1}, 5, all).kind, Kind::Point);
    EXPECT_EQ(scene.hit({2, 1}, 5, all).point, 0);
    EXPECT_EQ(scene.hit({2, 1}, 5, none).kind, Kind::Outline);
    EXPECT_EQ(scene.hit({50, 50}, 5, all).kind, Kind::Inside);
    EXPECT_EQ(scene.hit({50, 50}, 5, all).patch, firstSquare);
    EXPECT_EQ(scene.hit({150, 50}, 5, all).kind, Kind::Nothing);
}

TEST(PatternScene, FindsTheSeamAtAnOutline)
{
    PatternScene scene;
    scene.reset(twoSquares());
    const auto none = [](ElementId) { return false; };
    const PatternHit sewn = scene.hit({100, 40}, 5, none);
    EXPECT_EQ(sewn.seam, squareSeam);
    EXPECT_EQ(sewn.element(), squareSeam);
    EXPECT_NEAR(sewn.parameter, 1.4, 1e-6);
    EXPECT_EQ(scene.hit({40, 0}, 5, none).seam, settingsId);
    EXPECT_EQ(scene.hit({300, 60}, 5, none).seam, squareFixation);
}

TEST(PatternScene, FollowsTheDesign)
{
    Design design = twoSquares();
    PatternScene scene;
    scene.reset(design);
    EXPECT_TRUE(scene.boundingBox().isApprox(Box2(Vec2(0, 0), Vec2(300, 100))));

    const Edit turned = edits::turnPatches(design, std::array{secondSquare}, Vec2(250, 50), 45);
    const Design moved = design.with(turned);
    scene.update(moved, differences(design, moved));
    EXPECT_NEAR(scene.boundingBox().max().x(), 250 + 50 * std::sqrt(2), 1e-6);
    EXPECT_EQ(scene.stretches().size(), 3U);

    const Edit removed = edits::removeElements(moved, std::array{secondSquare});
    const Design less = moved.with(removed);
    scene.update(less, differences(moved, less));
    EXPECT_EQ(scene.patches().size(), 1U);
    EXPECT_TRUE(scene.stretches().empty());
}

TEST(PatternScene, KeepsLabelsInside)
{
    PatternScene scene;
    scene.reset(twoSquares());
    const LabelPlace& label = scene.patch(firstSquare)->label;
    EXPECT_NEAR(label.lying.centre.x(), 50, 8);
    EXPECT_NEAR(label.lying.centre.y(), 50, 30);
    EXPECT_TRUE(LabelPlace::fits(label.lying, {90, 20}));
    EXPECT_FALSE(LabelPlace::fits(label.lying, {120, 10}));
}

TEST(SeamColors, DifferAtOnePatch)
{
    Design design = twoSquares();
    for (int side = 0; side < 3; ++side) {
        const Seam seam{{firstSquare, side + 0.1, side + 0.2}, {secondSquare, side + 0.3, side + 0.4}};
        design = design.with(edits::addElement(design, makeElement(seam)));
    }
    const std::map<ElementId, QColor> colors = seamColors(design, false);
    EXPECT_EQ(colors.size(), 4U);
    std::set<QRgb> different;
    for (const auto& [id, color] : colors)
        different.insert(color.rgb());
    EXPECT_EQ(different.size(), 4U);
    EXPECT_EQ(colors, seamColors(design, false));
}

} // namespace
} // namespace bolster
