#include "OutlineDraft.h"

#include "DesignCheck.h"
#include "TypedEntry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bolster {
namespace {

const QLocale english(QLocale::English, QLocale::UnitedStates);
const QLocale german(QLocale::German, QLocale::Germany);

double distanceTo(const BSpline2& curve, const Vec2& point)
{
    return curve.closest(point).distance;
}

TEST(OutlineDraft, CornersAloneAreAPolygon)
{
    const auto outline = draftOutline({{{0, 0}}, {{100, 0}}, {{100, 0}}, {{100, 80}}, {{0, 80}}, {{0, 0}}});
    ASSERT_TRUE(outline);
    EXPECT_EQ(*outline, BSpline2(1, true, {{0, 0}, {100, 0}, {100, 80}, {0, 80}})) << "repeated points count once";
    EXPECT_FALSE(draftOutline(std::vector<DraftPoint>(2, DraftPoint{{100, 0}, {}}))) << "one place";
    std::vector<DraftPoint> line(2);
    line.back().at = {100, 0};
    EXPECT_FALSE(draftOutline(line));
    EXPECT_FALSE(draftOutline({}));
}

TEST(OutlineDraft, MixedOutlinesPassThroughTheirPoints)
{
    // Once with a corner in the beginning, once with a smooth point.
    const std::vector<DraftPoint> points = {
        {{0, 0}}, {{300, 0}}, {{300, 200}}, {{150, 280}, Vec2(-60, 10)}, {{0, 200}}};
    for (std::size_t turn = 0; turn < points.size(); ++turn) {
        std::vector<DraftPoint> turned = points;
        std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(turn), turned.end());
        const auto outline = draftOutline(turned);
        ASSERT_TRUE(outline);
        EXPECT_EQ(outline->degree(), 3);
        EXPECT_FALSE(outlineProblem(*outline));
        EXPECT_EQ(outline->corners().size(), 4U);
        for (const DraftPoint& point : points)
            EXPECT_LT(distanceTo(*outline, point.at), 1e-9) << turn;
        // Edges between corners are exactly straight, and walked evenly.
        for (const double share : {0.1, 0.25, 0.5, 0.9}) {
            EXPECT_LT(distanceTo(*outline, {300 * share, 0}), 1e-9);
            EXPECT_LT(distanceTo(*outline, {300, 200 * share}), 1e-9);
        }
        const auto at = outline->closest({150, 280});
        const Vec2 before = outline->derivative(at.parameter - 1e-7).normalized();
        const Vec2 after = outline->derivative(at.parameter + 1e-7).normalized();
        EXPECT_LT((before - after).norm(), 1e-4) << "no kink at a smooth point";
        EXPECT_LT((after - Vec2(-60, 10).normalized()).norm(), 1e-4) << "the tangent that was pulled";
    }
}

TEST(OutlineDraft, SmoothPointsAloneHaveNoCorners)
{
    const auto outline = draftOutline(
        {{{100, 0}, Vec2(0, 55)}, {{0, 100}, Vec2(-55, 0)}, {{-100, 0}, Vec2(0, -55)}, {{0, -100}, Vec2(55, 0)}});
    ASSERT_TRUE(outline);
    EXPECT_TRUE(outline->corners().empty());
    EXPECT_EQ(outline->pointCount(), 8);
    EXPECT_NEAR(outline->signedArea(), M_PI * 100 * 100, 100) << "almost a circle";
    const auto two = draftOutline({{{0, 0}, Vec2(0, -50)}, {{100, 0}, Vec2(0, 50)}});
    ASSERT_TRUE(two);
    EXPECT_FALSE(outlineProblem(*two));
}

TEST(OutlineDraft, SaysWhereAnOpenPathCrossesItself)
{
    std::vector<DraftPoint> points = {{{0, 0}}, {{100, 0}}, {{100, 100}}, {{50, 100}}};
    EXPECT_FALSE(crossesItself(draftPath(points), 1));
    points.push_back({{50, -50}});
    EXPECT_TRUE(crossesItself(draftPath(points), 1));
}

TEST(OutlineDraft, EllipsesAndRectanglesFillTheirBox)
{
    const auto ellipse = ellipseOutline({10, 20}, {310, -180});
    ASSERT_TRUE(ellipse);
    for (int i = 0; i < 100; ++i) {
        const Vec2 p = ellipse->at(ellipse->domainStart() + ellipse->period() * i / 100);
        EXPECT_NEAR(std::hypot((p.x() - 160) / 150, (p.y() + 80) / 100), 1, 3e-4);
    }
    EXPECT_NEAR(distanceTo(*ellipse, {310, -80}), 0, 1e-9) << "exactly as wide as the box";
    EXPECT_NEAR(distanceTo(*ellipse, {160, 20}), 0, 1e-9);
    EXPECT_FALSE(outlineProblem(*ellipse));
    EXPECT_EQ(*rectangleOutline({100, 0}, {0, 50}), BSpline2(1, true, {{0, 0}, {100, 0}, {100, 50}, {0, 50}}));
    EXPECT_FALSE(rectangleOutline({0, 0}, {100, 0}));
    EXPECT_FALSE(ellipseOutline({0, 0}, {0, 100}));
}

TEST(TypedStep, GoesWhereThePointerIsOrAtAnAngle)
{
    const auto step = [](const char* text, const QLocale& locale = english) {
        return typedStep(QString::fromUtf8(text), {0, 2}, locale).value_or(Vec2(1e9, 1e9));
    };
    EXPECT_LT((step("500") - Vec2(0, 500)).norm(), 1e-9);
    EXPECT_LT((step("5 cm") - Vec2(0, 50)).norm(), 1e-9);
    EXPECT_LT((step("100<30") - Vec2(50 * std::sqrt(3), 50)).norm(), 1e-9);
    EXPECT_LT((step("100;90\u00b0") - Vec2(0, 100)).norm(), 1e-9);
    EXPECT_LT((step("120,-40") - Vec2(120, -40)).norm(), 1e-9);
    EXPECT_LT((step("1 in, 2 in") - Vec2(25.4, 50.8)).norm(), 1e-9);
    EXPECT_LT((step("120,5", german) - Vec2(0, 120.5)).norm(), 1e-9) << "a comma is the decimal sign there";
    EXPECT_LT((step("120,5, 40", german) - Vec2(120.5, 40)).norm(), 1e-9);
    for (const char* text : {"", "abc", "5<", "<5", "1,2,3", "5<6<7", "5 kg"})
        EXPECT_FALSE(typedStep(QString::fromUtf8(text), {0, 1}, english)) << text;
    EXPECT_FALSE(typedStep(QStringLiteral("500"), {0, 0}, english)) << "no direction";
}

TEST(TypedSize, IsWidthByHeightTowardsThePointer)
{
    const Vec2 downRight(1, -1);
    const auto size = [&](const char* text) {
        return typedSize(QString::fromUtf8(text), downRight, english).value_or(Vec2(1e9, 1e9));
    };
    EXPECT_EQ(size("300x200"), Vec2(300, -200));
    EXPECT_EQ(size("300 \u00d7 200 mm"), Vec2(300, -200));
    EXPECT_EQ(size("30 cm X 2*100"), Vec2(300, -200));
    EXPECT_EQ(size("300;200"), Vec2(300, -200));
    EXPECT_EQ(size("300,200"), Vec2(300, -200));
    EXPECT_EQ(size("300"), Vec2(300, -300));
    EXPECT_FALSE(typedSize(QStringLiteral("300x"), downRight, english));
}

TEST(TypedEntryTest, APlaceInSpaceHasTwoOrThreeNumbers)
{
    const auto place = [](const char* text, const QLocale& locale) {
        return typedPlace(QString::fromUtf8(text), 7, locale).value_or(Vec3::Constant(1e9));
    };
    EXPECT_EQ(place("250,-100,40", english), Vec3(250, -100, 40));
    EXPECT_EQ(place("25 cm, 2*50; 3", english), Vec3::Constant(1e9));
    EXPECT_EQ(place("25 cm; -2*50", english), Vec3(250, -100, 7)) << "as high as before";
    EXPECT_EQ(place("1,5, 2,5, 3", german), Vec3(1.5, 2.5, 3));
    EXPECT_EQ(place("1,5;2;3", german), Vec3(1.5, 2, 3));
    for (const char* text : {"250", "1,2,3,4", "a,b", "1,2,"})
        EXPECT_FALSE(typedPlace(QString::fromUtf8(text), 0, english)) << text;
}

} // namespace
} // namespace bolster
