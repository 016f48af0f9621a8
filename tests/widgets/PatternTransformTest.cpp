#include "PatternTransform.h"
#include "PatternGrid.h"

#include <gtest/gtest.h>

namespace bolster {
namespace {

TEST(PatternTransform, GoesThereAndBack)
{
    const PatternTransform t = PatternTransform::fitting(Box2(Vec2(-100, 50), Vec2(400, 300)), {800, 600}, 20);
    for (const Vec2& p : {Vec2(0, 0), Vec2(-100, 50), Vec2(123.4, 567.8)}) {
        EXPECT_TRUE(t.toLayout(t.toPixels(p)).isApprox(p, 1e-12));
        EXPECT_EQ(t.matrix().map(QPointF(p.x(), p.y())), t.toPixels(p));
    }
    EXPECT_LT(t.toPixels({0, 100}).y(), t.toPixels({0, 0}).y()) << "y points up";
}

TEST(PatternTransform, FitsTheWholeBoxWithItsMargin)
{
    const Box2 box(Vec2(-100, 50), Vec2(400, 300));
    const PatternTransform t = PatternTransform::fitting(box, {800, 600}, 20, 100);
    EXPECT_NEAR(t.toPixels(box.min()).x(), 20, 1e-9);
    EXPECT_NEAR(t.toPixels(box.max()).x(), 780, 1e-9);
    EXPECT_NEAR(t.toPixels(box.center()).y(), 300, 1e-9);
    EXPECT_TRUE(t.visible({800, 600}).contains(box));
}

TEST(PatternTransform, KeepsThePointUnderThePointerWhenZooming)
{
    PatternTransform t;
    const QPointF pointer(312, 77);
    const Vec2 under = t.toLayout(pointer);
    for (int i = 0; i < 200; ++i)
        t = t.zoomed(pointer, 1.2);
    EXPECT_EQ(t.scale(), PatternTransform::largestScale);
    EXPECT_TRUE(t.toLayout(pointer).isApprox(under, 1e-9));
    for (int i = 0; i < 200; ++i)
        t = t.zoomed(pointer, 1 / 1.2);
    EXPECT_EQ(t.scale(), PatternTransform::smallestScale);
    EXPECT_TRUE(t.toLayout(pointer).isApprox(under, 1e-6));
}

TEST(PatternTransform, SurvivesWidgetsWithoutRoomAndBoxesWithoutSize)
{
    EXPECT_GT(PatternTransform::fitting({}, {0, 0}, 20).scale(), 0);
    EXPECT_GT(PatternTransform::fitting(Box2(Vec2(1, 1)), {10, 10}, 20).scale(), 0);
}

TEST(PatternGrid, ChoosesRoundSteps)
{
    EXPECT_DOUBLE_EQ(gridStep(1, 9), 10);
    EXPECT_DOUBLE_EQ(gridStep(10, 9), 1);
    EXPECT_DOUBLE_EQ(gridStep(0.1, 9), 100);
    EXPECT_DOUBLE_EQ(scaleBarLength(1, 130), 100);
    EXPECT_DOUBLE_EQ(scaleBarLength(0.25, 130), 500);
    EXPECT_DOUBLE_EQ(scaleBarLength(0.5, 130), 200);
    for (double scale = 0.002; scale < 200; scale *= 1.3) {
        EXPECT_GE(gridStep(scale) * scale, 9 - 1e-6);
        EXPECT_LE(gridStep(scale) * scale, 90 + 1e-6);
        EXPECT_LE(scaleBarLength(scale) * scale, 130 + 1e-6);
    }
}

} // namespace
} // namespace bolster
