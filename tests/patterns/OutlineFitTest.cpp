// Curves with few points near the lines of drawings.
#include "OutlineFit.h"

#include <gtest/gtest.h>

#include <numbers>

namespace bolster {

namespace {

Contour closedLine(const std::vector<Vec2>& points)
{
    Contour contour;
    contour.closed = true;
    for (const Vec2& at : points)
        contour.points.push_back({at});
    return contour;
}

} // namespace

TEST(OutlineFit, PolygonsStayPolygons)
{
    const auto fit = fittedCurve(closedLine({{0, 0}, {100, 0}, {200, 0}, {200, 80}, {0, 80}}));
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->degree(), 1);
    EXPECT_EQ(fit->pointCount(), 4) << "a point in the middle of an edge is no corner";
    EXPECT_NEAR(fit->signedArea(), 16000, 1e-9);
}

TEST(OutlineFit, CirclesHaveFewPointsAndNoCorner)
{
    std::vector<Vec2> points;
    for (int k = 0; k < 90; ++k)
        points.push_back(150 * Vec2(std::cos(k * std::numbers::pi / 45), std::sin(k * std::numbers::pi / 45)));
    const auto fit = fittedCurve(closedLine(points));
    ASSERT_TRUE(fit);
    EXPECT_TRUE(fit->corners().empty());
    EXPECT_LE(fit->pointCount(), 24);
    for (double t = 0; t < fit->period(); t += fit->period() / 500)
        EXPECT_NEAR(fit->at(fit->wrapped(fit->domainStart() + t)).norm(), 150, 0.05);
}

TEST(OutlineFit, RoundedRectanglesHaveStraightEdges)
{
    std::vector<Vec2> points;
    const Vec2 centres[] = {{280, 20}, {280, 180}, {20, 180}, {20, 20}};
    for (int corner = 0; corner < 4; ++corner)
        for (int k = 0; k <= 12; ++k) {
            const double angle = (corner - 1 + k / 12.0) * std::numbers::pi / 2;
            points.push_back(centres[corner] + 20 * Vec2(std::cos(angle), std::sin(angle)));
        }
    const auto fit = fittedCurve(closedLine(points));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->signedArea(), 300 * 200 - (4 - std::numbers::pi) * 400, 6);
    EXPECT_LT(fit->closest({150, 0}).distance, 0.03);
    EXPECT_LT(fit->closest({300, 100}).distance, 0.03);
}

TEST(OutlineFit, NothingOfTooFewPoints)
{
    EXPECT_FALSE(fittedCurve(closedLine({{0, 0}, {1, 1}})));
    EXPECT_FALSE(fittedCurve(closedLine({{0, 0}, {0, 0}, {0, 0}, {1, 1}})));
}

} // namespace bolster
