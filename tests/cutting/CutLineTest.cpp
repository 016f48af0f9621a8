// Allowances against figures that can be worked out by hand, and rules that hold for any outline.
#include "CutPiece.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace bolster {

namespace {

SewingLine polygon(const std::vector<Vec2>& points, double width, CornerJoin join = CornerJoin::Mitred)
{
    SewingLine line;
    for (const Vec2& point : points)
        line.vertices.push_back({point, width, true, join});
    return line;
}

const std::vector<Vec2> square{{0, 0}, {100, 0}, {100, 100}, {0, 100}};

std::vector<LinePoint> asLine(const SewingLine& sewn)
{
    std::vector<LinePoint> line;
    for (const SewingLine::Vertex& vertex : sewn.vertices)
        line.push_back({vertex.at, vertex.corner});
    return line;
}

bool crossesItself(const std::vector<LinePoint>& line)
{
    const auto side = [](const Vec2& a, const Vec2& b, const Vec2& p) { return cross(b - a, p - a); };
    const std::size_t n = line.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = i + 2; k < n; ++k) {
            if (i == 0 && k == n - 1)
                continue;
            const Vec2 &a = line[i].at, &b = line[(i + 1) % n].at, &c = line[k].at, &d = line[(k + 1) % n].at;
            if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0)
                return true;
        }
    return false;
}

BSpline2 circle(double radius)
{
    // 24 control points: within 0.01 mm of a circle, whose radius is measured below.
    std::vector<Vec2> points;
    for (int k = 0; k < 24; ++k)
        points.push_back(radius *
                         Vec2(std::cos(2 * std::numbers::pi * k / 24), std::sin(2 * std::numbers::pi * k / 24)));
    return BSpline2(3, true, points);
}

SewingLine sewnAlong(const BSpline2& outline, double width)
{
    SewingLine line;
    for (const OutlineSample& sample : sampled(outline, {0.05, width, {}}))
        line.vertices.push_back({sample.at, width, sample.corner, CornerJoin::Mitred});
    return line;
}

} // namespace

TEST(CutLine, OfASquareIsASquareThatIsLargerByTwoAllowances)
{
    const CutLine cut = cutLineOf(polygon(square, 10));
    ASSERT_EQ(cut.points.size(), 4u);
    EXPECT_NEAR(areaOf(cut.points), 120 * 120, 0.01);
    for (const LinePoint& point : cut.points)
        EXPECT_TRUE(point.corner);
    EXPECT_TRUE(cut.gaps.empty());
}

TEST(CutLine, WithoutAllowanceIsTheSewingLine)
{
    const SewingLine line = polygon(square, 0);
    EXPECT_EQ(cutLineOf(line).points, asLine(line));
}

TEST(CutLine, HasCornersAsTheyAreAskedFor)
{
    const double pi = std::numbers::pi;
    EXPECT_NEAR(areaOf(cutLineOf(polygon(square, 10, CornerJoin::Rounded)).points), 14000 + 100 * pi, 0.5);
    // A square corner is cut off at the allowance's distance: the mitre's tip is 10 sqrt(2) away.
    const double cutOff = std::pow(10 * std::numbers::sqrt2 - 10, 2);
    EXPECT_NEAR(areaOf(cutLineOf(polygon(square, 10, CornerJoin::Square)).points), 14400 - 4 * cutOff, 0.05);
    // At right angles the mirror image of a cut line is the cut line.
    EXPECT_NEAR(areaOf(cutLineOf(polygon(square, 10, CornerJoin::Folded)).points), 14400, 0.05);
    EXPECT_NEAR(areaOf(cutLineOf(polygon(square, 10, CornerJoin::Stepped)).points), 14400, 0.05);
}

TEST(CutLine, MitresThatWouldBeLongAreCutOff)
{
    const CutLine cut = cutLineOf(polygon({{0, 0}, {200, 0}, {0, 20}}, 10));
    double farthest = 0;
    for (const LinePoint& point : cut.points)
        farthest = std::max(farthest, point.at.x());
    EXPECT_LT(farthest, 200 + 41);
    EXPECT_GT(farthest, 200 + 20);
}

TEST(CutLine, AFoldedAllowanceLiesUnderThePiece)
{
    // Interior angles of 60 and of 120 degrees: the first edge's allowance narrows and widens.
    for (const double lean : {100 / std::sqrt(3.0), -100 / std::sqrt(3.0)}) {
        SewingLine line = polygon({{0, 0}, {300, 0}, {300 - lean, 100}, {0, 100}}, 10);
        line.vertices[1].join = CornerJoin::Folded;
        const CutLine cut = cutLineOf(line);
        int looked = 0;
        for (const LinePoint& point : cut.points)
            if (point.at.y() < -1 && point.at.x() > 250) { // folded up along the first edge
                const Vec2 folded(point.at.x(), -point.at.y());
                EXPECT_TRUE(isInside(cut.points, folded) || distanceTo(cut.points, folded) < 1e-3)
                    << folded.transpose();
                ++looked;
            }
        EXPECT_GT(looked, 0);
        EXPECT_FALSE(crossesItself(cut.points));
    }
}

TEST(CutLine, ASteppedCornerEndsAtRightAngles)
{
    SewingLine line = polygon({{0, 0}, {200, 0}, {300, 100}, {0, 100}}, 10);
    line.vertices[1].join = CornerJoin::Stepped;
    const CutLine cut = cutLineOf(line);
    // Straight out from where the other cut line crosses the edge: at 200 + 10 sqrt(2).
    const double foot = 200 + 10 * std::numbers::sqrt2;
    EXPECT_LT(distanceTo(cut.points, {foot, -5}), 1e-3);
    EXPECT_LT(distanceTo(cut.points, {foot, -10}), 1e-3);
}

TEST(CutLine, FoldedAndSteppedCornersHaveALimitAsMitresHave)
{
    // The edges turn by 3 degrees, and by 177.
    const double narrow = 300 * std::tan(3 * std::numbers::pi / 180);
    const std::vector<Vec2> shapes[] = {{{0, 0}, {300, 0}, {600, narrow}, {600, 300}, {0, 300}},
                                        {{0, 0}, {300, narrow}, {0, narrow}}};
    for (const CornerJoin join : {CornerJoin::Folded, CornerJoin::Stepped})
        for (const std::vector<Vec2>& shape : shapes) {
            SewingLine line = polygon(shape, 10);
            line.vertices[1].join = join;
            const CutLine cut = cutLineOf(line);
            EXPECT_FALSE(crossesItself(cut.points));
            for (const LinePoint& point : cut.points)
                EXPECT_LE(distanceTo(asLine(line), point.at), 42) << point.at.transpose();
        }
}

TEST(CutLine, EdgesHaveAllowancesOfTheirOwn)
{
    SewingLine line = polygon(square, 10);
    line.vertices[0].width = 0;  // bottom
    line.vertices[1].width = 25; // right
    const CutLine cut = cutLineOf(line);
    Box2 box;
    for (const LinePoint& point : cut.points)
        box.extend(point.at);
    EXPECT_NEAR(box.min().y(), 0, 1e-3);
    EXPECT_NEAR(box.max().x(), 125, 1e-3);
    EXPECT_NEAR(areaOf(cut.points), 135 * 110, 0.05);
}

TEST(CutLine, RoundedCornersBetweenUnequalAllowancesLeaveNeither)
{
    SewingLine line = polygon(square, 10, CornerJoin::Rounded);
    line.vertices[0].width = 34.5; // bottom
    const CutLine cut = cutLineOf(line);
    Box2 box;
    for (const LinePoint& point : cut.points)
        box.extend(point.at);
    EXPECT_NEAR(box.min().y(), -34.5, 1e-3);
    EXPECT_NEAR(box.min().x(), -10, 1e-3) << "no nose beside the corner";
    EXPECT_NEAR(box.max().x(), 110, 1e-3);
    // Two quarters of a circle above, two of an ellipse below.
    const double pi = std::numbers::pi;
    EXPECT_NEAR(areaOf(cut.points), 100 * (100 + 10 + 34.5 + 2 * 10) + pi / 2 * (10 * 10 + 10 * 34.5), 1);
}

TEST(CutLine, OfACurveIsOffsetWithin50Micrometres)
{
    for (const double width : {0.5, 8.0, 30.0}) {
        const BSpline2 outline = circle(60);
        const double radius = outline.at(0.3).norm();
        const CutLine cut = cutLineOf(sewnAlong(outline, width));
        for (std::size_t i = 0; i < cut.points.size(); ++i) {
            const Vec2 middle = (cut.points[i].at + cut.points[(i + 1) % cut.points.size()].at) / 2;
            EXPECT_NEAR(cut.points[i].at.norm(), radius + width, 0.05);
            EXPECT_NEAR(middle.norm(), radius + width, 0.05);
            EXPECT_FALSE(cut.points[i].corner) << "a curve has no corners";
        }
        const double exact = std::numbers::pi * std::pow(radius + width, 2);
        EXPECT_NEAR(areaOf(cut.points), exact, 1e-3 * exact);
    }
}

TEST(CutLine, AtInnerCornersIsWhereBothAllowancesMeet)
{
    const CutLine cut = cutLineOf(polygon({{0, 0}, {100, 0}, {100, 40}, {40, 40}, {40, 100}, {0, 100}}, 10));
    ASSERT_EQ(cut.points.size(), 6u);
    EXPECT_LT(distanceTo(cut.points, {50, 50}), 1e-3);
    EXPECT_NEAR(areaOf(cut.points), 120 * 60 + 60 * 60, 0.05);
}

TEST(CutLine, SaysWhereItMeetsItself)
{
    // A ring with a gap of 10 mm, which allowances of 10 mm close.
    const CutLine cut = cutLineOf(polygon({{0, 0},
                                           {200, 0},
                                           {200, 200},
                                           {105, 200},
                                           {105, 150},
                                           {150, 150},
                                           {150, 50},
                                           {50, 50},
                                           {50, 150},
                                           {95, 150},
                                           {95, 200},
                                           {0, 200}},
                                          10));
    EXPECT_EQ(cut.gaps.size(), 1u);
    EXPECT_NEAR(areaOf(cut.points), 220 * 220, 0.1) << "the outer line";
}

TEST(CutLine, OfAnyCurveIsNowhereNearerOrFartherThanItsAllowance)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(0.45, 1.0);
    for (int round = 0; round < 60; ++round) {
        std::vector<Vec2> points;
        const int count = 6 + round % 9;
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * k / count;
            points.push_back(260 * share(random) * Vec2(std::cos(angle), std::sin(angle)));
        }
        const double width = 1 + round % 20;
        const BSpline2 outline(3, true, points);
        const CutLine cut = cutLineOf(sewnAlong(outline, width));
        ASSERT_GE(cut.points.size(), 3u);
        EXPECT_FALSE(crossesItself(cut.points)) << "round " << round;
        for (std::size_t i = 0; i < cut.points.size(); ++i) {
            const Vec2 &a = cut.points[i].at, &b = cut.points[(i + 1) % cut.points.size()].at;
            EXPECT_NEAR(outline.closest(a).distance, width, 0.05) << "round " << round;
            EXPECT_NEAR(outline.closest((a + b) / 2).distance, width, 0.05) << "round " << round;
        }
    }
}

TEST(CutLine, NeverCrossesItselfAndKeepsItsDistance)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.25, 1.0), width(0, 25);
    constexpr CornerJoin joins[] = {CornerJoin::Mitred, CornerJoin::Square, CornerJoin::Rounded, CornerJoin::Folded,
                                    CornerJoin::Stepped};
    for (int round = 0; round < 200; ++round) {
        SewingLine line;
        const int count = 3 + round % 12;
        double narrowest = 1e9;
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * k / count;
            const double w = width(random);
            narrowest = std::min(narrowest, w);
            line.vertices.push_back(
                {150 * share(random) * Vec2(std::cos(angle), std::sin(angle)), w, true, joins[random() % 5]});
        }
        const std::vector<LinePoint> sewn = asLine(line);
        const CutLine cut = cutLineOf(line);
        ASSERT_GE(cut.points.size(), 3u);
        EXPECT_FALSE(crossesItself(cut.points)) << "round " << round;
        EXPECT_GE(areaOf(cut.points), areaOf(sewn) - 0.01);
        for (const LinePoint& point : sewn)
            EXPECT_TRUE(isInside(cut.points, point.at) || distanceTo(cut.points, point.at) < 2e-3) << round;
        for (const LinePoint& point : cut.points)
            EXPECT_FALSE(isInside(sewn, point.at) && distanceTo(sewn, point.at) > 2e-3) << round;
        for (const LinePoint& point : cut.points)
            EXPECT_LE(distanceTo(sewn, point.at), 25 * std::sqrt(17.0) + 0.01) << "no corner goes on for ever";
    }
}

} // namespace bolster
