#include "BSpline.h"

#include "Random.h"

#include <gtest/gtest.h>

namespace bolster {
namespace {

using test::Random;

const std::vector<Vec2> square = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};

// Calls check(t) for parameters spread over the domain, its ends included.
template <int Dim, class Check>
void overDomain(const BSpline<Dim>& curve, Check check)
{
    for (int i = 0; i <= 40; ++i)
        check(curve.domainStart() + curve.period() * i / 40);
}

template <int Dim>
double difference(const BSpline<Dim>& a, const BSpline<Dim>& b)
{
    double largest = 0;
    overDomain(a, [&](double t) { largest = std::max(largest, (a.at(t) - b.at(t)).norm()); });
    return largest;
}

// Calls test(curve, random) for many curves of every degree, open and closed, in 2D and 3D.
template <class Test>
void forRandomCurves(unsigned seed, Test test)
{
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        const int degree = random.whole(1, 3);
        const bool closed = random.chance(0.6);
        SCOPED_TRACE(testing::Message() << "curve " << i << " degree " << degree << (closed ? " closed" : " open"));
        if (random.chance(0.5))
            test(test::randomCurve<2>(random, degree, closed), random);
        else
            test(test::randomCurve<3>(random, degree, closed), random);
    }
}

TEST(BSpline, PlacesAreMeansOfTheirPoints)
{
    forRandomCurves(77, [](const auto& curve, Random&) {
        overDomain(curve, [&](double t) {
            auto mean = curve.at(t);
            mean.setZero();
            double all = 0;
            for (const auto& [point, share] : curve.influencesAt(t)) {
                EXPECT_GE(share, 0);
                all += share;
                mean += share * curve.points()[static_cast<std::size_t>(point)];
            }
            EXPECT_NEAR(all, 1, 1e-12);
            EXPECT_LT((mean - curve.at(t)).norm(), 1e-9);
        });
    });
}

TEST(BSpline, PolygonPassesItsPointsAtWholeParameters)
{
    const BSpline2 polygon(1, true, square);
    EXPECT_EQ(polygon.domainStart(), 0);
    EXPECT_EQ(polygon.domainEnd(), 4);
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(polygon.at(i), square[static_cast<std::size_t>(i)]);
    EXPECT_EQ(polygon.at(3.5), Vec2(0, 50));
    EXPECT_EQ(polygon.at(4), square[0]);
    EXPECT_EQ(polygon.at(-0.5), Vec2(0, 50));
    EXPECT_EQ(polygon.corners(), (std::vector<double>{0, 1, 2, 3}));
}

TEST(BSpline, UniformClosedCubicIsTheMeanOfThreePointsAtItsKnots)
{
    const BSpline2 curve(3, true, square);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 expected = (square[(i + 3) % 4] + 4 * square[i] + square[(i + 1) % 4]) / 6;
        EXPECT_LT((curve.at(static_cast<double>(i)) - expected).norm(), 1e-13);
        EXPECT_EQ(curve.parameterOfPoint(static_cast<int>(i)), static_cast<double>(i));
    }
    EXPECT_TRUE(curve.corners().empty());
}

TEST(BSpline, FindsThePointThatRulesAParameter)
{
    const BSpline2 closed(1, true, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    EXPECT_EQ(closed.pointAt(1.2), 1);
    EXPECT_EQ(closed.pointAt(3.8), 0); // round the start
    const BSpline2 open(1, false, {{0, 0}, {10, 0}, {20, 0}});
    EXPECT_EQ(open.pointAt(1.8), 2);
    EXPECT_EQ(BSpline2().pointAt(0), -1);
}

TEST(BSpline, UniformClosedQuadraticPassesTheMiddlesOfItsEdges)
{
    const BSpline2 curve(2, true, square);
    for (std::size_t i = 0; i < 4; ++i) // basis i has the support k_(i-1)..k_(i+2): at k_i the points i-1 and i act
        EXPECT_LT((curve.at(static_cast<double>(i)) - (square[(i + 3) % 4] + square[i]) / 2).norm(), 1e-13);
}

TEST(BSpline, OpenCurvesAreClampedToTheirEnds)
{
    const BSpline3 curve(3, false, {{0, 0, 0}, {1, 2, 0}, {3, 2, 1}, {4, 0, 2}, {6, 1, 1}});
    EXPECT_EQ(curve.knots(), (std::vector<double>{0, 0, 0, 0, 1, 2, 2, 2, 2}));
    EXPECT_EQ(curve.at(0), Vec3(0, 0, 0));
    EXPECT_EQ(curve.at(2), Vec3(6, 1, 1));
    EXPECT_EQ(curve.at(-5), curve.at(0));
    EXPECT_EQ(curve.at(5), curve.at(2));
    EXPECT_EQ(curve.breaks(), (std::vector<double>{0, 1, 2}));
}

TEST(BSpline, CornersAreInterpolatedAtTheirIndex)
{
    std::vector<Vec2> points;
    for (int i = 0; i < 10; ++i)
        points.emplace_back(100 * std::cos(0.6 * i), 80 * std::sin(0.6 * i));
    const BSpline2 curve = BSpline2::withCorners(points, {0, 3, 7});
    for (const int corner : {0, 3, 7})
        EXPECT_LT((curve.at(corner) - points[static_cast<std::size_t>(corner)]).norm(), 1e-13);
    EXPECT_EQ(curve.corners(), (std::vector<double>{0, 3, 7}));
    EXPECT_EQ(curve.cornerIndices(), (std::vector<int>{0, 3, 7}));
    EXPECT_EQ(curve.period(), 10);
    // The other knots lie evenly between the corners: 4 points from 3 to 7 leave one, at 5.
    EXPECT_EQ(curve.knots(), (std::vector<double>{0, 0, 3, 3, 3, 5, 7, 7, 7, 10, 10}));
}

TEST(BSpline, CornersNeedNotBeginWithTheFirstPoint)
{
    std::vector<Vec2> points;
    for (int i = 0; i < 11; ++i)
        points.emplace_back(100 * std::cos(0.57 * i), 80 * std::sin(0.57 * i));
    const std::vector<int> corners = {2, 5, 9};
    const BSpline2 curve = BSpline2::withCorners(points, corners);
    EXPECT_EQ(curve.cornerIndices(), corners);
    for (const int corner : corners)
        EXPECT_LT((curve.at(corner) - points[static_cast<std::size_t>(corner)]).norm(), 1e-13);
}

TEST(BSpline, StraightEdgeWithItsPointsAtTheThirdsIsStraightAndEven)
{
    const BSpline2 curve = BSpline2::withCorners(
        {{0, 0}, {10, 0}, {20, 0}, {30, 0}, {30, 10}, {30, 20}, {30, 30}, {20, 20}, {10, 10}}, {0, 3, 6});
    for (double t = 0; t <= 3; t += 0.25)
        EXPECT_LT((curve.at(t) - Vec2(10 * t, 0)).norm(), 1e-12);
    EXPECT_NEAR(curve.signedArea(), 450, 1e-9);
}

TEST(BSpline, DerivativesAreThoseOfDifferences)
{
    forRandomCurves(1, [](const auto& curve, Random& random) {
        const double t = random.real(curve.domainStart(), curve.domainEnd());
        double gap = 1;
        for (const double knot : curve.breaks())
            gap = std::min(gap, std::abs(knot - t));
        const double h = std::min(1e-4, gap / 2);
        if (h < 1e-5)
            return;
        for (int order = 1; order <= 3; ++order) {
            const auto value = [&](double u) { return order == 1 ? curve.at(u) : curve.derivative(u, order - 1); };
            const auto expected = ((value(t + h) - value(t - h)) / (2 * h)).eval();
            const double scale = 1 + expected.norm() + curve.derivative(t, 3).norm();
            EXPECT_LT((curve.derivative(t, order) - expected).norm() / scale, 1e-4) << "order " << order;
        }
        EXPECT_EQ(curve.derivative(t, 4).norm(), 0);
    });
}

TEST(BSpline, InsertingAKnotKeepsTheShapeAndEveryParameter)
{
    forRandomCurves(2, [](const auto& curve, Random& random) {
        const auto& knots = curve.knots();
        const double present = knots[static_cast<std::size_t>(random.whole(0, static_cast<int>(knots.size()) - 1))];
        for (const double t : {random.real(curve.domainStart() - 3, curve.domainEnd() + 3), present,
                               curve.domainStart(), curve.domainEnd(), random.real(0, 1) * 1e-13}) {
            const auto finer = curve.withKnot(t);
            EXPECT_LT(difference(curve, finer), 1e-10) << "knot " << t;
            EXPECT_EQ(finer.domainStart(), curve.domainStart());
            EXPECT_EQ(finer.domainEnd(), curve.domainEnd());
            EXPECT_LE(finer.pointCount(), curve.pointCount() + 1);
        }
    });
}

TEST(BSpline, KnotsOfFullMultiplicityAreCornersAndTakeNoMore)
{
    const BSpline2 smooth(3, true, {{0, 0}, {100, 0}, {120, 80}, {50, 130}, {-20, 80}});
    for (const double t : {0.0, 1.0, 2.5, 5.0}) {
        BSpline2 curve = smooth;
        for (int i = 0; i < 3; ++i)
            curve = curve.withKnot(t);
        EXPECT_EQ(curve.pointCount(), t == 2.5 ? 8 : 7) << "others are knots already";
        EXPECT_EQ(curve.corners(), std::vector<double>{smooth.wrapped(t)});
        EXPECT_EQ(curve.withKnot(t), curve);
        EXPECT_LT(difference(smooth, curve), 1e-10);
        bool interpolated = false;
        for (const Vec2& point : curve.points())
            interpolated = interpolated || (point - smooth.at(t)).norm() < 1e-10;
        EXPECT_TRUE(interpolated);
    }
}

TEST(BSpline, RemovingAnInsertedPointGivesTheCurveBack)
{
    forRandomCurves(3, [](const auto& curve, Random& random) {
        const auto finer = curve.withKnot(random.real(curve.domainStart(), curve.domainEnd()));
        if (finer == curve)
            return;
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < finer.pointCount(); ++i)
            if (const auto coarser = finer.withoutPoint(i)) {
                EXPECT_EQ(coarser->pointCount(), curve.pointCount());
                EXPECT_NEAR(coarser->period(), curve.period(), 1e-12);
                least = std::min(least, difference(curve, *coarser));
            }
        EXPECT_LT(least, 1e-8);
    });
}

TEST(BSpline, RemovingACornerOfAPolygonLeavesTheOthersAlone)
{
    const BSpline2 polygon(1, true, {{0, 0}, {100, 0}, {150, 60}, {100, 100}, {0, 100}});
    for (int i = 0; i < 5; ++i) {
        const auto without = polygon.withoutPoint(i);
        ASSERT_TRUE(without);
        EXPECT_EQ(without->pointCount(), 4);
        EXPECT_EQ(without->period(), 5);
        for (int k = 0; k < 5; ++k)
            EXPECT_TRUE(k == i || (without->at(k) - polygon.at(k)).norm() < 1e-12)
                << "corner " << k << " without " << i;
    }
}

TEST(BSpline, RemovingAPointBetweenCornersKeepsThem)
{
    std::vector<Vec2> points;
    for (int i = 0; i < 12; ++i)
        points.emplace_back(100 * std::cos(0.52 * i), 80 * std::sin(0.52 * i));
    const BSpline2 curve = BSpline2::withCorners(points, {0, 5, 8});
    const auto without = curve.withoutPoint(2);
    ASSERT_TRUE(without);
    for (const double corner : {0.0, 5.0, 8.0})
        EXPECT_LT((without->at(corner) - curve.at(corner)).norm(), 1e-12);
    EXPECT_EQ(without->corners(), curve.corners());
    EXPECT_EQ(without->domainEnd(), curve.domainEnd());
    EXPECT_LT(difference(curve, *without), 5);
    EXPECT_FALSE(curve.withoutPoint(6)) << "the corners 5 and 8 need the two points between them";
    const auto smoother = curve.withoutPoint(5);
    ASSERT_TRUE(smoother);
    EXPECT_EQ(smoother->corners(), (std::vector<double>{0, 8}));
}

TEST(BSpline, KeepsAsManyPointsAsACurveNeeds)
{
    EXPECT_FALSE(BSpline2(1, true, {{0, 0}, {1, 0}, {0, 1}}).withoutPoint(1));
    EXPECT_FALSE(BSpline3(3, false, {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 1, 1}}).withoutPoint(1));
    EXPECT_FALSE(BSpline3(1, false, {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}}).withoutPoint(0)) << "an end stays";
    EXPECT_TRUE(BSpline3(1, false, {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}}).withoutPoint(1));
}

TEST(BSpline, PartsHaveTheShapeOfTheWhole)
{
    forRandomCurves(4, [](const auto& curve, Random& random) {
        double from = random.real(curve.domainStart(), curve.domainEnd());
        double to = random.real(curve.domainStart(), curve.domainEnd());
        if (random.chance(0.3))
            from = curve.wrapped(curve.knots()[curve.knots().size() / 2]);
        if (random.chance(0.2))
            to = curve.closed() ? from : curve.domainEnd();
        if (!curve.closed() && from > to)
            std::swap(from, to);
        if (std::abs(to - from) < 1e-3 && (!curve.closed() || to != from))
            return;
        const auto part = curve.part(from, to);
        EXPECT_FALSE(part.closed());
        const double extent = to > from ? to - from : to - from + curve.period();
        EXPECT_NEAR(part.period(), extent, 1e-9);
        for (int i = 0; i <= 20; ++i) {
            const double ahead = extent * i / 20;
            EXPECT_LT((part.at(part.domainStart() + ahead) - curve.at(from + ahead)).norm(), 1e-9);
        }
    });
    EXPECT_THROW(BSpline2(1, false, {{0, 0}, {1, 1}}).part(0.5, 0.5), std::invalid_argument);
}

TEST(BSpline, ReversedRunsBackwards)
{
    forRandomCurves(5, [](const auto& curve, Random&) {
        const auto back = curve.reversed();
        EXPECT_EQ(back.domainStart(), curve.domainStart());
        EXPECT_EQ(back.domainEnd(), curve.domainEnd());
        overDomain(curve, [&](double t) {
            const double mirrored = curve.domainStart() + curve.domainEnd() - t;
            EXPECT_LT((back.at(mirrored) - curve.at(t)).norm(), 1e-10);
        });
        EXPECT_NEAR(back.signedArea(), -curve.signedArea(), 1e-8);
        EXPECT_LT(difference(back.reversed(), curve), 1e-10);
    });
    const BSpline2 cornered =
        BSpline2::withCorners({{0, 0}, {10, 0}, {20, 3}, {30, 0}, {40, 10}, {30, 30}, {20, 32}, {10, 20}}, {0, 3});
    EXPECT_EQ(cornered.reversed().cornerIndices(), (std::vector<int>{0, 5}));
    EXPECT_EQ(cornered.reversed().reversed(), cornered);
    EXPECT_TRUE(BSpline2(2, true, square).reversed().hasDefaultKnots());
}

TEST(BSpline, ClosestPointIsNeverFartherThanAnySample)
{
    forRandomCurves(6, [](const auto& curve, Random& random) {
        using Point = typename std::decay_t<decltype(curve)>::Point;
        constexpr int dim = Point::RowsAtCompileTime;
        const double onCurve = random.real(curve.domainStart(), curve.domainEnd());
        for (const Point& p : {test::randomPoint<dim>(random, 200), test::randomPoint<dim>(random, 20),
                               Point(curve.at(onCurve)), Point::Zero().eval()}) {
            const auto closest = curve.closest(p);
            for (int i = 0; i <= 500; ++i) {
                const Point sample = curve.at(curve.domainStart() + curve.period() * i / 500);
                ASSERT_LE(closest.distance, (sample - p).norm() + 1e-9);
            }
            EXPECT_LT((curve.at(closest.parameter) - closest.point).norm(), 1e-9);
            EXPECT_NEAR((closest.point - p).norm(), closest.distance, 1e-12);
        }
        EXPECT_LT(curve.closest(curve.at(onCurve)).distance, 1e-9);
    });
}

TEST(BSpline, ClosestPointOfACircleFromItsCentre)
{
    std::vector<Vec2> points;
    for (int i = 0; i < 40; ++i)
        points.emplace_back(100 * std::cos(2 * std::numbers::pi * i / 40),
                            100 * std::sin(2 * std::numbers::pi * i / 40));
    const BSpline2 circle(3, true, points);
    EXPECT_NEAR(circle.closest(Vec2(0, 0)).distance, circle.at(0).norm(), 1e-2);
}

TEST(BSpline, BoundingBoxIsTight)
{
    forRandomCurves(7, [](const auto& curve, Random&) {
        const auto box = curve.boundingBox();
        auto sampled = box;
        sampled.setEmpty();
        for (const double knot : curve.breaks())
            sampled.extend(curve.at(knot));
        for (int i = 0; i <= 3000; ++i)
            sampled.extend(curve.at(curve.domainStart() + curve.period() * i / 3000));
        EXPECT_LT((box.max() - sampled.max()).cwiseAbs().maxCoeff(), 0.05);
        EXPECT_LT((box.min() - sampled.min()).cwiseAbs().maxCoeff(), 0.05);
        EXPECT_TRUE((box.max().array() >= sampled.max().array() - 1e-10).all());
        EXPECT_TRUE((box.min().array() <= sampled.min().array() + 1e-10).all());
    });
}

TEST(BSpline, AreaIsPositiveCounterClockwise)
{
    EXPECT_DOUBLE_EQ(BSpline2(1, true, square).signedArea(), 10000);
    EXPECT_DOUBLE_EQ(BSpline2(1, true, square).reversed().signedArea(), -10000);
    EXPECT_EQ(BSpline2(1, false, square).signedArea(), 0);
    forRandomCurves(8, [](const auto& curve, Random&) {
        if (std::decay_t<decltype(curve)>::Point::RowsAtCompileTime != 2 || !curve.closed())
            return;
        double area = 0;
        constexpr int steps = 4000;
        for (int i = 0; i < steps; ++i) {
            const auto p = curve.at(curve.domainStart() + curve.period() * i / steps);
            const auto q = curve.at(curve.domainStart() + curve.period() * (i + 1) / steps);
            area += (p[0] * q[1] - p[1] * q[0]) / 2;
        }
        EXPECT_NEAR(curve.signedArea(), area, 1e-4 * area);
    });
}

TEST(BSpline, WrapsParametersIntoTheDomain)
{
    const BSpline2 polygon(1, true, square, {1, 2, 3, 4, 5});
    EXPECT_EQ(polygon.wrapped(5), 1);
    EXPECT_EQ(polygon.wrapped(0.5), 4.5);
    EXPECT_EQ(polygon.wrapped(13.25), 1.25);
    EXPECT_EQ(polygon.wrapped(std::nextafter(1.0, 0.0)), 1) << "rounding must not reach the end";
    EXPECT_EQ(polygon.at(0.5), polygon.at(4.5));
}

TEST(BSpline, RefusesWhatIsNoCurve)
{
    const auto wrong = [](int degree, bool closed, std::vector<Vec2> points, std::vector<double> knots = {}) {
        const bool refused = BSpline2::problem(degree, closed, points, knots).has_value();
        bool thrown = false;
        try {
            BSpline2(degree, closed, points, knots);
        } catch (const std::invalid_argument&) {
            thrown = true;
        }
        EXPECT_EQ(refused, thrown);
        return refused;
    };
    EXPECT_TRUE(wrong(0, true, square));
    EXPECT_TRUE(wrong(4, true, square));
    EXPECT_TRUE(wrong(1, true, {{0, 0}, {1, 1}}));
    EXPECT_TRUE(wrong(3, false, {{0, 0}, {1, 1}, {2, 0}}));
    EXPECT_TRUE(wrong(1, true, {{0, 0}, {1, 1}, {2, std::nan("")}}));
    EXPECT_TRUE(wrong(1, true, {{0, 0}, {1, 1}, {2, 1.1e7}}));
    EXPECT_FALSE(wrong(1, true, {{0, 0}, {1e7, 1}, {2, -1e7}}));
    EXPECT_TRUE(wrong(1, true, square, {0, 1, 2, 3})) << "too few knots";
    EXPECT_TRUE(wrong(1, true, square, {0, 1, 3, 2, 4})) << "decreasing";
    EXPECT_TRUE(wrong(1, true, square, {0, 0, 0, 0, 0})) << "no period";
    EXPECT_TRUE(wrong(1, true, square, {0, 1, 1, 2, 3})) << "a polygon has single knots";
    EXPECT_TRUE(wrong(1, true, square, {0, 1, 2, 3, 3})) << "the end is the start";
    EXPECT_TRUE(wrong(1, true, square, {0, 1, 1 + 1e-12, 2, 3})) << "almost equal";
    EXPECT_TRUE(wrong(1, true, square, {0, 1, 2, 3, std::nan("")}));
    EXPECT_FALSE(wrong(1, true, square, {-2, 1, 2.5, 3, 100}));
    EXPECT_FALSE(wrong(3, true, square, {0, 0, 1, 2, 2})) << "a corner at the start: knots on both sides of it";
    EXPECT_TRUE(wrong(3, true, square, {0, 0, 0, 2, 2})) << "one too many there";
    EXPECT_TRUE(wrong(2, false, square, {0, 0, 0, 1, 2, 2, 3})) << "not clamped at the end";
    EXPECT_TRUE(wrong(2, false, square, {0, 0, 1, 1, 2, 2, 2})) << "not clamped at the start";
    EXPECT_FALSE(wrong(2, false, square, {0, 0, 0, 1, 2, 2, 2}));
    EXPECT_TRUE(BSpline2::cornerProblem(2, true, 12, {0, 3}));
    EXPECT_TRUE(BSpline2::cornerProblem(3, false, 12, {0, 3}));
    EXPECT_TRUE(BSpline2::cornerProblem(3, true, 12, {0, 2}));
    EXPECT_TRUE(BSpline2::cornerProblem(3, true, 12, {0, 12}));
    EXPECT_TRUE(BSpline2::cornerProblem(3, true, 12, {3, 0}));
    EXPECT_TRUE(BSpline2::cornerProblem(3, true, 12, {1, 11})) << "10 and 1 lie across the start";
    EXPECT_TRUE(BSpline2::cornerProblem(3, true, 12, {}));
    EXPECT_FALSE(BSpline2::cornerProblem(3, true, 12, {1, 10}));
    EXPECT_FALSE(BSpline2::cornerProblem(3, true, 3, {0})) << "a drop with one corner";
}

} // namespace
} // namespace bolster
