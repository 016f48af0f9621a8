#include "CurveFit.h"
#include "HandleEdits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bolster {
namespace {

constexpr double pi = std::numbers::pi;

CurveSamples sampled(Vec3 (*at)(double), int count, bool closed, std::vector<double> corners = {})
{
    CurveSamples samples;
    samples.closed = closed;
    samples.corners = std::move(corners);
    for (int k = 0; k < count; ++k) {
        samples.parameters.push_back(double(k) / (closed ? count : count - 1));
        samples.points.push_back(at(samples.parameters.back()));
    }
    return samples;
}

double largestError(const BSpline3& curve, const CurveSamples& samples)
{
    double error = 0;
    for (std::size_t k = 0; k < samples.points.size(); ++k)
        error = std::max(error, (curve.at(samples.parameters[k]) - samples.points[k]).norm());
    return error;
}

TEST(CurveFit, AStraightLineNeedsFourPoints)
{
    const CurveSamples samples = sampled([](double t) { return Vec3(500 * t, 20, -7 * t); }, 100, false);
    const BSpline3 curve = fitCurve(samples, 0.2);
    EXPECT_EQ(curve.pointCount(), 4);
    EXPECT_LT(largestError(curve, samples), 1e-9);
}

TEST(CurveFit, TakesAsManyPointsAsTheToleranceAsksFor)
{
    const CurveSamples samples = sampled(
        [](double t) { return Vec3(400 * t, 30 * std::sin(6 * pi * t), 10 * std::cos(4 * pi * t)); }, 400, false);
    int before = 0;
    for (const double tolerance : {5.0, 0.2, 0.01}) {
        const BSpline3 curve = fitCurve(samples, tolerance);
        EXPECT_LE(largestError(curve, samples), tolerance);
        EXPECT_GT(curve.pointCount(), before);
        EXPECT_LT(curve.pointCount(), 60);
        EXPECT_LT((curve.at(0) - samples.points.front()).norm(), 1e-6) << "ends are met";
        EXPECT_LT((curve.at(1) - samples.points.back()).norm(), 1e-6);
        before = curve.pointCount();
    }
}

TEST(CurveFit, ThousandsOfFoldsAreFittedAtOnce) // minutes with a full matrix
{
    const int folds = 2000, perFold = 10;
    CurveSamples samples;
    samples.end = folds;
    samples.closed = true;
    for (int k = 0; k < folds * perFold; ++k) {
        const double t = static_cast<double>(k) / perFold, turn = 2 * pi * t / folds;
        const double radius = 3000 + 20 * std::abs(t - std::floor(t) - 0.5);
        samples.parameters.push_back(t);
        samples.points.emplace_back(radius * std::cos(turn), radius * std::sin(turn), 0);
        if (k % perFold == 0)
            samples.corners.push_back(t);
    }
    const BSpline3 curve = fitCurve(samples, 1);
    EXPECT_EQ(curve.corners().size(), samples.corners.size());
    EXPECT_LE(largestError(curve, samples), 1);
}

TEST(CurveFit, ClosedCurvesStayClosedAndSmooth)
{
    const CurveSamples samples = sampled(
        [](double t) {
            return Vec3(100 * std::cos(2 * pi * t), 80 * std::sin(2 * pi * t), 5 * std::sin(4 * pi * t));
        },
        200, true);
    const BSpline3 curve = fitCurve(samples, 0.2);
    EXPECT_TRUE(curve.closed());
    EXPECT_TRUE(curve.corners().empty());
    EXPECT_LE(largestError(curve, samples), 0.2);
    EXPECT_LE(curve.pointCount(), 16);
}

TEST(CurveFit, KeepsCorners)
{
    const auto zigzag = [](double t) { return Vec3(200 * t, t < 0.5 ? 100 * t : 100 - 100 * t, 0); };
    const CurveSamples open = sampled(zigzag, 101, false, {0.5});
    const BSpline3 curve = fitCurve(open, 0.2);
    EXPECT_EQ(curve.corners(), std::vector<double>{0.5});
    EXPECT_EQ(curve.pointCount(), 7);
    EXPECT_LT(largestError(curve, open), 1e-6);

    const auto square = [](double t) {
        const double u = 4 * t, v = u - std::floor(u);
        return std::array{Vec3(v, 0, 0), Vec3(1, v, 0), Vec3(1 - v, 1, 0),
                          Vec3(0, 1 - v, 0)}[static_cast<std::size_t>(u)];
    };
    for (const std::vector<double>& corners : {std::vector{0.0, 0.25, 0.5, 0.75}, std::vector{0.25, 0.5, 0.75}}) {
        const CurveSamples closed = sampled(square, 80, true, corners);
        const BSpline3 loop = fitCurve(closed, corners.size() == 4 ? 1e-3 : 0.1);
        EXPECT_EQ(loop.corners(), corners);
        EXPECT_LT(largestError(loop, closed), corners.size() == 4 ? 1e-6 : 0.1);
    }
}

TEST(CurveFit, GivesUpRefiningWhereSamplesEnd)
{
    // Noise that no curve with so few points can follow: it ends, and is still a curve.
    const CurveSamples noise =
        sampled([](double t) { return Vec3(100 * t, 50 * std::sin(1e4 * t), 0); }, 40, false);
    const BSpline3 curve = fitCurve(noise, 1e-6);
    EXPECT_FALSE(BSpline3::problem(3, false, curve.points(), curve.knots()));
    EXPECT_LT(curve.pointCount(), 40);
}

TEST(DrawnCurve, IsAPolygonByArcLengthOrSmooth)
{
    const std::vector<Vec2> points{{0, 0}, {30, 40}, {30, 140}, {80, 140}};
    const BSpline2 polygon = *edits::drawnCurve(points, false, false);
    EXPECT_EQ(polygon.at(50), Vec2(30, 40));
    EXPECT_EQ(polygon.domainEnd(), 200);
    EXPECT_EQ(edits::drawnCurve(points, true, false)->degree(), 1);
    EXPECT_TRUE(edits::drawnCurve(points, true, false)->closed());
    EXPECT_EQ(edits::drawnCurve(points, false, true)->degree(), 3);
    EXPECT_EQ(edits::drawnCurve({{0, 0}, {1, 0}}, false, true)->degree(), 1);
    EXPECT_EQ(edits::drawnCurve({{0, 0}, {1, 0}, {1, 1}}, true, true)->degree(), 3);
    EXPECT_FALSE(edits::drawnCurve({{0, 0}}, false, false));
    EXPECT_FALSE(edits::drawnCurve({{0, 0}, {1, 0}}, true, false));
    EXPECT_FALSE(edits::drawnCurve({{5, 5}, {5, 5}}, false, false));
}

} // namespace
} // namespace bolster
