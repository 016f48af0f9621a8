#include "ArcLength.h"

#include "Random.h"

#include <gtest/gtest.h>

namespace bolster {
namespace {

template <int Dim>
double polygonLength(const BSpline<Dim>& curve, double from, double to, int steps)
{
    double length = 0;
    for (int k = 0; k < steps; ++k)
        length +=
            (curve.at(from + (to - from) * (k + 1) / steps) - curve.at(from + (to - from) * k / steps)).norm();
    return length;
}

TEST(ArcLength, OfAPolygonIsTheSumOfItsEdges)
{
    const ArcLength2 length(BSpline2(1, true, {{0, 0}, {30, 0}, {30, 40}}));
    EXPECT_DOUBLE_EQ(length.total(), 120);
    EXPECT_DOUBLE_EQ(length.at(1.5), 50);
    EXPECT_DOUBLE_EQ(length.parameterAt(50), 1.5);
    EXPECT_DOUBLE_EQ(length.between(2, 3), 50);
}

TEST(ArcLength, OfAParabolaHasItsClosedForm)
{
    const ArcLength2 length(BSpline2(2, false, {{0, 0}, {0.5, 0}, {1, 1}})); // (t, t^2)
    const auto closedForm = [](double t) { return t * std::sqrt(1 + 4 * t * t) / 2 + std::asinh(2 * t) / 4; };
    EXPECT_NEAR(length.total(), closedForm(1), 1e-12);
    for (const double t : {0.1, 0.35, 0.5, 0.8})
        EXPECT_NEAR(length.at(t), closedForm(t), 1e-12);
}

TEST(ArcLength, ContinuesPeriodicallyOnClosedCurves)
{
    const ArcLength2 length(BSpline2(1, true, {{0, 0}, {30, 0}, {30, 40}}));
    EXPECT_DOUBLE_EQ(length.at(-1), -50);
    EXPECT_DOUBLE_EQ(length.at(4), 150);
    EXPECT_DOUBLE_EQ(length.at(3), 120);
    EXPECT_DOUBLE_EQ(length.parameterAt(150), 4);
    EXPECT_DOUBLE_EQ(length.parameterAt(-50), -1);
}

TEST(ArcLength, ClampsOnOpenCurves)
{
    const ArcLength2 length(BSpline2(1, false, {{0, 0}, {30, 0}, {30, 40}}));
    EXPECT_EQ(length.at(-1), 0);
    EXPECT_DOUBLE_EQ(length.at(9), 70);
    EXPECT_EQ(length.parameterAt(-3), 0);
    EXPECT_DOUBLE_EQ(length.parameterAt(100), 2);
}

TEST(ArcLength, AgreesWithFinePolygonsAndItsInverse)
{
    test::Random random(1);
    for (int i = 0; i < 200; ++i) {
        const BSpline3 curve = test::randomCurve<3>(random, random.whole(1, 3), random.chance(0.5));
        const ArcLength3 length(curve);
        const double from = random.real(curve.domainStart(), curve.domainEnd());
        const double to = random.real(from, curve.domainEnd());
        std::vector<double> places = {from, to}; // with the corners between
        for (const double knot : curve.breaks())
            if (knot > from && knot < to)
                places.insert(places.end() - 1, knot);
        double polygon = 0;
        for (std::size_t k = 0; k + 1 < places.size(); ++k)
            polygon += polygonLength(curve, places[k], places[k + 1], 500);
        EXPECT_NEAR(length.between(from, to), polygon, 1e-5 * length.total());
        for (int k = 0; k <= 20; ++k) {
            const double s = length.total() * k / 20;
            EXPECT_NEAR(length.at(length.parameterAt(s)), s, 1e-9 * length.total());
        }
    }
}

TEST(ArcLength, IsAccurateAcrossACusp)
{
    // With these points the curve stops in the middle and turns back.
    const BSpline2 cusp(3, false, {{0, 0}, {100, 100}, {0, 100}, {100, 0}});
    const ArcLength2 length(cusp);
    EXPECT_NEAR(length.total(), polygonLength(cusp, 0, 1, 200000), 1e-5);
}

TEST(ArcLength, TakesPiecesWithoutLength)
{
    const ArcLength2 doubled(BSpline2(1, true, {{0, 0}, {10, 0}, {10, 0}, {0, 10}}));
    EXPECT_DOUBLE_EQ(doubled.at(1), doubled.at(2));
    EXPECT_DOUBLE_EQ(doubled.at(doubled.parameterAt(10)), 10);
    EXPECT_NEAR(doubled.parameterAt(10 + 1e-6), 2, 1e-6);

    const ArcLength2 point(BSpline2(3, true, {{5, 5}, {5, 5}, {5, 5}}));
    EXPECT_EQ(point.total(), 0);
    EXPECT_EQ(point.parameterAt(0), 0);
    EXPECT_EQ(point.at(2.5), 0);
}

} // namespace
} // namespace bolster
