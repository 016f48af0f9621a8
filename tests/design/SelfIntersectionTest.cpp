#include "DesignCheck.h"

#include "Random.h"

#include <gtest/gtest.h>

namespace bolster {
namespace {

double cross(const Vec2& a, const Vec2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

// Whether a fine polygon along the curve crosses itself.
bool polygonCrosses(const BSpline2& curve, int count)
{
    std::vector<Vec2> p;
    for (int i = 0; i < count; ++i)
        p.push_back(curve.at(curve.domainStart() + curve.period() * i / count));
    const auto at = [&](int i) { return p[static_cast<std::size_t>(i % count)]; };
    for (int i = 0; i < count; ++i) {
        for (int j = i + 2; j < count - (i == 0); ++j) {
            const Vec2 u = at(i + 1) - at(i);
            const Vec2 v = at(j + 1) - at(j);
            if (cross(u, at(j) - at(i)) * cross(u, at(j + 1) - at(i)) < 0 &&
                cross(v, at(i) - at(j)) * cross(v, at(i + 1) - at(j)) < 0)
                return true;
        }
    }
    return false;
}

TEST(SelfIntersection, FindsTheCrossingOfABowTie)
{
    const auto found = selfIntersection(BSpline2(1, true, {{0, 0}, {100, 100}, {100, 0}, {0, 100}}));
    ASSERT_TRUE(found);
    EXPECT_LT((*found - Vec2(50, 50)).norm(), 1e-6);
}

TEST(SelfIntersection, TouchingCounts)
{
    EXPECT_TRUE(selfIntersection(BSpline2(1, true, {{0, 0}, {100, 0}, {100, 100}, {50, 0}, {0, 100}})))
        << "point on edge";
    EXPECT_TRUE(selfIntersection(BSpline2(1, true, {{0, 0}, {100, 0}, {50, 50}, {100, 100}, {0, 100}, {50, 50}})))
        << "point on point";
    EXPECT_TRUE(selfIntersection(BSpline2(1, true, {{0, 0}, {100, 0}, {100, 100}, {100, 20}, {0, 100}})))
        << "folded back";
    EXPECT_TRUE(selfIntersection(BSpline2(1, true, {{0, 0}, {100, 0}, {200, 0}}))) << "flat";
}

TEST(SelfIntersection, LetsNarrowShapesPass)
{
    EXPECT_FALSE(selfIntersection(BSpline2(1, true, {{0, 0}, {1000, 0}, {1000, 0.01}, {0, 0.01}}))) << "a ribbon";
    EXPECT_FALSE(selfIntersection(BSpline2(1, true, {{0, 0}, {100, 0}, {100, 100}, {99.9, 10}, {0, 100}})))
        << "a dart";
    EXPECT_FALSE(selfIntersection(BSpline2(1, true, {{0, 0}, {100, 0}, {100, 0}, {100, 100}})))
        << "a doubled point";
    EXPECT_FALSE(selfIntersection(BSpline2(3, true, {{0, 0}, {100, 0}, {120, 80}})));
}

TEST(SelfIntersection, TellsParallelCurvesFromTouchingOnes)
{
    // A crescent: two arcs about the same centre, `gap` apart.
    const auto crescent = [](double gap) {
        std::vector<Vec2> points;
        for (int i = 0; i <= 20; ++i)
            points.emplace_back(100 * std::cos(0.1 * i), 100 * std::sin(0.1 * i));
        for (int i = 20; i >= 0; --i)
            points.emplace_back((100 - gap) * std::cos(0.1 * i), (100 - gap) * std::sin(0.1 * i));
        return BSpline2(3, true, points);
    };
    EXPECT_FALSE(selfIntersection(crescent(5)));
    EXPECT_FALSE(selfIntersection(crescent(0.01)));
    EXPECT_TRUE(selfIntersection(crescent(0)));
}

TEST(SelfIntersection, FindsLoopsWithinOneSpan)
{
    EXPECT_TRUE(selfIntersection(
        BSpline2::withCorners({{0, 0}, {150, 100}, {-50, 100}, {100, 0}, {100, -50}, {0, -50}}, {0, 3})));
    EXPECT_FALSE(selfIntersection(
        BSpline2::withCorners({{0, 0}, {20, 100}, {80, 100}, {100, 0}, {100, -50}, {0, -50}}, {0, 3})));
}

TEST(SelfIntersection, AgreesWithFinePolygons)
{
    test::Random random(3);
    int crossing = 0;
    for (int i = 0; i < 400; ++i) {
        const int degree = random.whole(1, 3);
        const int count = random.whole(4, 12);
        const double jitter = random.real(0, 1.2);
        std::vector<Vec2> points;
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * k / count + random.real(-jitter, jitter);
            points.push_back(random.real(50, 150) * Vec2(std::cos(angle), std::sin(angle)));
        }
        const BSpline2 curve = degree == 3 && count > 5 && random.chance(0.4)
                                   ? BSpline2::withCorners(points, {0, 3})
                                   : BSpline2(degree, true, points);
        const auto found = selfIntersection(curve);
        EXPECT_EQ(found.has_value(), polygonCrosses(curve, 400)) << "outline " << i;
        if (found) {
            EXPECT_LT(curve.closest(*found).distance, 0.01);
            ++crossing;
        }
    }
    EXPECT_GT(crossing, 40);
    EXPECT_LT(crossing, 360);
}

TEST(SelfIntersection, OfAPointIsNone)
{
    EXPECT_FALSE(selfIntersection(BSpline2(3, true, {{5, 5}, {5, 5}, {5, 5}})));
}

} // namespace
} // namespace bolster
