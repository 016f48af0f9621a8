#include "TestDesigns.h"

#include "ArcLength.h"
#include "OutlineSampling.h"
#include "SpokenName.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bolster::test {
namespace {

/// Fraction of a stretch's length at which a sample lies.
double lengthFraction(const BSpline2& outline, double from, double to, double t)
{
    const ArcLength2 length(outline);
    const double end = unwrappedEnd(from, to, outline.domainStart(), outline.domainEnd());
    while (t < from - 1e-9)
        t += outline.period();
    return length.between(from, t) / length.between(from, end);
}

double parameterFraction(const BSpline2& outline, double from, double to, double t)
{
    const double end = unwrappedEnd(from, to, outline.domainStart(), outline.domainEnd());
    while (t < from - 1e-9)
        t += outline.period();
    return (t - from) / (end - from);
}

BSpline2 blob(double size, int points)
{
    std::vector<Vec2> control;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * EIGEN_PI * i / points;
        const double radius = size * (1 + 0.25 * std::cos(2 * angle + 0.4));
        control.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return BSpline2(3, true, control);
}

BSpline2 cornered()
{
    return BSpline2::withCorners({{0, 0},
                                  {60, -20},
                                  {130, 10},
                                  {200, 0},
                                  {220, 40},
                                  {180, 90},
                                  {200, 150},
                                  {130, 160},
                                  {70, 140},
                                  {0, 150},
                                  {-10, 100},
                                  {10, 50}},
                                 {0, 3, 6, 9});
}

struct Case {
    const char* name;
    BSpline2 a, b;
    double aFrom, aTo, bFrom, bTo;
    bool reversed;
    Match match;
};

class SeamMatching : public testing::TestWithParam<Case> {};

TEST_P(SeamMatching, PairsEqualFractions)
{
    const Case& c = GetParam();
    DesignBuilder builder(9);
    const ElementId fabric = builder.fabric(0.3, 5);
    const ElementId a = builder.patch(c.a, fabric), b = builder.patch(c.b, fabric);
    builder.seam({a, c.aFrom, c.aTo}, {b, c.bFrom, c.bTo}, c.reversed, c.match);
    const OutlineSampling sampling = sampleOutlines(builder.design());
    ASSERT_TRUE(sampling.problems.empty());
    ASSERT_EQ(sampling.seams.size(), 1u);
    const auto& chain = sampling.seams[0];
    ASSERT_EQ(chain.a.size(), chain.b.size());
    ASSERT_GT(chain.a.size(), 5u);
    auto fraction = c.match == Match::Length ? lengthFraction : parameterFraction;
    for (std::size_t k = 1; k + 1 < chain.a.size(); ++k) {
        const double fa = fraction(c.a, c.aFrom, c.aTo, sampling.outlines[0].parameters[chain.a[k]]);
        const double fb = fraction(c.b, c.bFrom, c.bTo, sampling.outlines[1].parameters[chain.b[k]]);
        EXPECT_NEAR(fa, c.reversed ? 1 - fb : fb, 1e-6) << k;
        EXPECT_EQ(sampling.outlines[0].cluster[chain.a[k]], sampling.outlines[1].cluster[chain.b[k]]);
    }
}

const BSpline2 square(1, true, rectangle(100, 100));
const BSpline2 wide(1, true, rectangle(140, 60));

INSTANTIATE_TEST_SUITE_P(
    Ways, SeamMatching,
    testing::Values(Case{"plain", square, wide, 0, 1, 2, 3, true, Match::Length},
                    Case{"forward", square, wide, 0, 1, 2, 3, false, Match::Length},
                    Case{"byParameter", square, wide, 0, 1, 2, 3, true, Match::Parameter},
                    Case{"acrossACorner", square, wide, 0, 1, 1, 3, true, Match::Length},
                    Case{"acrossACornerByParameter", square, wide, 0, 2, 2, 3, false, Match::Parameter},
                    Case{"passingTheStart", square, wide, 3, 1, 0, 1, true, Match::Length},
                    Case{"untilTheEnd", square, wide, 3, 4, 0, 1, true, Match::Length},
                    Case{"splines", blob(80, 9), blob(100, 14), 7.5, 2.25, 3, 9.5, true, Match::Length},
                    Case{"splinesForward", blob(80, 9), blob(100, 14), 7.5, 2.25, 3, 9.5, false, Match::Length},
                    Case{"splinesByParameter", blob(80, 9), blob(100, 14), 7.5, 2.25, 3, 9.5, true,
                         Match::Parameter},
                    Case{"corners", cornered(), blob(80, 9), 3, 9, 1, 6, true, Match::Length},
                    Case{"cornersPassingTheStart", cornered(), blob(80, 9), 9, 3, 6, 1, false, Match::Length}),
    [](const auto& way) { return way.param.name; });

/// A corner near two of the other side belongs to the nearer one, from whichever end one looks.
TEST(OutlineSampling, CornersCloseTogetherPairWithTheNearest)
{
    for (const double other : {94.4, 105.6}) {
        DesignBuilder builder(30);
        const ElementId fabric = builder.fabric(0.3, 5);
        const BSpline2 two(
            1, true,
            {{0, 0}, {std::min(other, 100.0), 0}, {std::max(other, 100.0), 0}, {200, 0}, {200, 90}, {0, 90}});
        const BSpline2 one(1, true, {{0, 0}, {200, 0}, {200, 90}, {99.9, 90}, {0, 90}});
        const ElementId a = builder.patch(two, fabric), b = builder.patch(one, fabric);
        builder.seam({a, 0, 3}, {b, 2, 4}, true);
        const OutlineSampling sampling = sampleOutlines(builder.design());
        ASSERT_TRUE(sampling.problems.empty());
        const auto& chain = sampling.seams[0];
        ASSERT_EQ(chain.a.size(), chain.b.size());
        for (std::size_t k = 0; k < chain.a.size(); ++k)
            EXPECT_NEAR(sampling.outlines[0].points[chain.a[k]].x(), sampling.outlines[1].points[chain.b[k]].x(),
                        0.11)
                << other;
    }
}

/// A corner a millionth of an edge behind the beginning of a seam hid all the others from it, and the program
/// ended.
TEST(OutlineSampling, CornersWithinRoundingOfAnEndAreThatEnd)
{
    for (const double apart : {2e-5, 2e-4, 4e-4}) {
        DesignBuilder builder(30);
        const ElementId fabric = builder.fabric(0.3, 5);
        const BSpline2 two(1, true, {{0, 0}, {apart, 0}, {120, 0}, {200, 0}, {200, 90}, {0, 90}});
        const BSpline2 one(1, true, {{0, 0}, {200, 0}, {200, 90}, {120, 90}, {0, 90}});
        const ElementId a = builder.patch(two, fabric), b = builder.patch(one, fabric);
        builder.seam({a, 0, 3}, {b, 2, 4}, true);
        builder.seam({a, 4, 0}, {b, 4, 0}, true);
        const OutlineSampling sampling = sampleOutlines(builder.design());
        ASSERT_TRUE(sampling.problems.empty()) << apart;
        for (const auto& chain : sampling.seams)
            EXPECT_EQ(chain.a.size(), chain.b.size()) << apart;
        std::size_t corners = 0;
        for (const int sample : sampling.seams[0].a)
            corners += std::abs(sampling.outlines[0].points[sample].x() - 120) < 1e-6;
        EXPECT_EQ(corners, 1U) << apart;
    }
}

TEST(OutlineSampling, WholeOutlinesCanBeSewn)
{
    DesignBuilder b(10);
    const ElementId fabric = b.fabric(0.3, 5);
    const ElementId front = b.patch(blob(90, 10), fabric), back = b.patch(blob(90, 10), fabric);
    b.seam({front, 2, 2}, {back, 5, 5});
    const OutlineSampling sampling = sampleOutlines(b.design());
    ASSERT_TRUE(sampling.problems.empty());
    const auto& chain = sampling.seams[0];
    EXPECT_EQ(chain.a.size(), sampling.outlines[0].points.size() + 1);
    EXPECT_EQ(chain.a.front(), chain.a.back());
    EXPECT_NEAR(sampling.outlines[0].parameters[chain.a[0]], 2, 1e-9);
}

TEST(OutlineSampling, EdgesAreAboutAsLongAsAskedFor)
{
    DesignBuilder b(7);
    b.patch(cornered(), b.fabric(0.3, 5));
    const std::vector<Vec2> points = sampleOutlines(b.design()).outlines[0].points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double edge = (points[(i + 1) % points.size()] - points[i]).norm();
        EXPECT_GT(edge, 0.35 * 7);
        EXPECT_LT(edge, 1.6 * 7);
    }
}

TEST(OutlineSampling, CornersOfAFixationCurveGetAVertex)
{
    DesignBuilder b(10);
    const ElementId patch = b.patch(rectangle(100, 50), b.fabric(0.3, 5));
    b.fix({patch, 0, 1}, polyline({{0, 0, 0}, {37, 0, 0}, {37, 0, 63}}));
    const OutlineSampling sampling = sampleOutlines(b.design());
    double nearest = 1e9;
    for (const Vec3& target : sampling.fixations[0].targets)
        nearest = std::min(nearest, (target - Vec3(37, 0, 0)).norm());
    EXPECT_LT(nearest, 1e-9);
}

TEST(OutlineSampling, OneVertexCannotBeInTwoPlaces)
{
    DesignBuilder b(10);
    const ElementId patch = b.patch(rectangle(100, 50), b.fabric(0.3, 5));
    const ElementId first = b.fix({patch, 0, 1}, polyline({{0, 0, 0}, {100, 0, 0}}));
    const ElementId second = b.fix({patch, 1, 2}, polyline({{100, 0, 1.5}, {100, 50, 0}}));
    const Problems problems = sampleOutlines(b.design()).problems;
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].element, second);
    EXPECT_EQ(problems[0].field, "curve");
    const Design& design = b.design();
    for (ElementId fixation : {first, second}) {
        const ElementId curve = design.find<FixationSeam>(fixation)->curve;
        EXPECT_NE(problems[0].message.english().find(spokenName(design, curve)), std::string::npos)
            << problems[0].message.english();
    }
}

TEST(OutlineSampling, TargetsThatMeetWithinAMillimetreAreFine)
{
    DesignBuilder b(10);
    const ElementId patch = b.patch(rectangle(100, 50), b.fabric(0.3, 5));
    b.fix({patch, 0, 1}, polyline({{0, 0, 0}, {100, 0, 0}}));
    b.fix({patch, 1, 2}, polyline({{100, 0, 0.9}, {100, 50, 0}}));
    EXPECT_TRUE(sampleOutlines(b.design()).problems.empty());
}

TEST(OutlineSampling, FixationsFollowDirectionAndMatch)
{
    for (bool reversed : {false, true})
        for (Match match : {Match::Length, Match::Parameter}) {
            DesignBuilder b(10);
            const ElementId patch = b.patch(rectangle(100, 50), b.fabric(0.3, 5));
            const BSpline3 curve(3, false, {{0, 0, 0}, {5, 0, 30}, {60, 0, 40}, {90, 0, 10}, {100, 0, 0}});
            b.fix({patch, 0, 1}, curve, reversed, match);
            const auto chain = sampleOutlines(b.design()).fixations[0];
            const ArcLength3 length(curve);
            for (std::size_t k = 0; k < chain.samples.size(); ++k) {
                double f = static_cast<double>(k) / static_cast<double>(chain.samples.size() - 1);
                if (reversed)
                    f = 1 - f;
                const double t =
                    match == Match::Length ? length.parameterAt(f * length.total()) : f * curve.period();
                EXPECT_LT((chain.targets[k] - curve.at(t)).norm(), 1e-6);
            }
        }
}

TEST(OutlineSampling, ThreeLayersShareOneSeamLine)
{
    DesignBuilder b(10);
    const ElementId fabric = b.fabric(0.3, 5);
    const ElementId p = b.patch(rectangle(100, 50), fabric), q = b.patch(rectangle(100, 70), fabric),
                    r = b.patch(rectangle(104, 60), fabric);
    b.seam({p, 0, 1}, {q, 0, 1});
    b.seam({p, 0, 1}, {r, 0, 1});
    const OutlineSampling sampling = sampleOutlines(b.design());
    ASSERT_TRUE(sampling.problems.empty());
    ASSERT_EQ(sampling.seams[0].a, sampling.seams[1].a);
    for (std::size_t k = 0; k < sampling.seams[0].a.size(); ++k)
        EXPECT_EQ(sampling.outlines[1].cluster[sampling.seams[0].b[k]],
                  sampling.outlines[2].cluster[sampling.seams[1].b[k]]);
}

} // namespace
} // namespace bolster::test
