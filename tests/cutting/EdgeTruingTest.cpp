// Edges become equally long, and what lies beside them keeps its shape.
#include "DartEdits.h"
#include "DesignCheck.h"
#include "LengthEdits.h"
#include "StretchLength.h"

#include "Panels.h"

#include <gtest/gtest.h>

#include <array>

namespace bolster {

namespace {

using namespace test;

/// A rectangle as a cubic, three points an edge: its corners lie at 0, 3, 6, 9.
BSpline2 cubicRectangle(double width, double height)
{
    const std::array<Vec2, 4> corners{Vec2(0, 0), Vec2(width, 0), Vec2(width, height), Vec2(0, height)};
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < 4; ++i)
        for (int k = 0; k < 3; ++k)
            points.push_back(corners[i] + k / 3.0 * (corners[(i + 1) % 4] - corners[i]));
    return BSpline2::withCorners(points, {0, 3, 6, 9});
}

/// twoPanels, of polygons or of cubics; an edge is `unit` long in parameters.
struct SewnPanels {
    Design design;
    double unit = 1;
};

SewnPanels sewnPanels(bool cubic)
{
    SewnPanels pair{twoPanels()};
    if (!cubic)
        return pair;
    pair.unit = 3;
    for (const ElementId id : {left, right}) {
        Patch patch = *pair.design.find<Patch>(id);
        patch.outline = cubicRectangle(200, 100);
        pair.design = with(pair.design, id, patch);
    }
    Seam seam = *pair.design.find<Seam>(between);
    seam.a = {left, 3, 6};
    seam.b = {right, 9, 12};
    pair.design = with(pair.design, between, seam);
    return pair;
}

std::vector<ElementId> dartsOf(const Design& design)
{
    std::vector<ElementId> found;
    design.each<Seam>([&](ElementId id, const Seam&) {
        if (edits::dartOf(design, id))
            found.push_back(id);
    });
    return found;
}

/// The seams between both panels, by where they begin on the left one.
std::vector<ElementId> acrossSeams(const Design& design)
{
    std::vector<std::pair<double, ElementId>> found;
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        if (seam.a.patch == left && seam.b.patch == right)
            found.emplace_back(seam.a.from, id);
    });
    std::ranges::sort(found);
    std::vector<ElementId> ids;
    for (const auto& [from, id] : found)
        ids.push_back(id);
    return ids;
}

void expectStraight(const BSpline2& outline, double from, double to)
{
    const Vec2 a = outline.at(outline.wrapped(from)), b = outline.at(outline.wrapped(to));
    for (double share = 0.1; share < 1; share += 0.1) {
        const Vec2 at = outline.at(outline.wrapped(from + share * (to - from)));
        EXPECT_LT(std::abs(cross(Vec2(at - a), Vec2((b - a).normalized()))), 1e-9) << from << " to " << to;
    }
}

void expectEven(const Design& design, ElementId id)
{
    const Seam& seam = *design.find<Seam>(id);
    EXPECT_NEAR(stretchLength(design, seam.a), stretchLength(design, seam.b), 1e-6);
}

Design made(const Design& design, const Edit& edit, const Message& problem)
{
    EXPECT_FALSE(edit.empty()) << problem.english();
    const Design now = design.with(edit);
    for (const Problem& found : checkDesign(now))
        EXPECT_NE(found.severity, Severity::Error) << found.english();
    return now;
}

Design sidesEqual(const Design& design, const std::vector<ElementId>& seams)
{
    Message problem;
    return made(design, edits::makeSeamSidesEqual(design, seams, &problem), problem);
}

/// All darts are such still, and their mouths and tips have moved by that.
void expectDart(const Design& design, const Design& before, const Vec2& moved)
{
    ASSERT_EQ(dartsOf(design), dartsOf(before)) << "their legs are straight";
    for (const ElementId id : dartsOf(before)) {
        const auto was = edits::dartOf(before, id), is = edits::dartOf(design, id);
        const BSpline2 &old = before.find<Patch>(was->patch)->outline,
                       &now = design.find<Patch>(is->patch)->outline;
        EXPECT_LT((now.at(is->from) - old.at(was->from) - moved).norm(), 1e-6);
        EXPECT_LT((now.at(is->to) - old.at(was->to) - moved).norm(), 1e-6);
        EXPECT_LT((is->tip - was->tip - moved).norm(), 1e-6);
    }
}

} // namespace

TEST(EdgeTruing, LeavesADartBesideTheSeamAsItIs)
{
    for (const bool cubic : {false, true}) {
        SCOPED_TRACE(cubic);
        const auto [design, unit] = sewnPanels(cubic);
        // In the right edge of the left panel, which is sewn to the other one: both parts become too short.
        const Design cut = design.with(edits::addDart(design, {left, 1.3 * unit, 1.5 * unit, {150, 40}}));
        const std::vector<ElementId> seams = acrossSeams(cut);
        ASSERT_EQ(seams.size(), 2u);
        for (const std::vector<ElementId>& chosen :
             {std::vector{seams[0]}, std::vector{seams[1]}, std::vector{seams[0], seams[1]}}) {
            const Design now = sidesEqual(cut, chosen);
            for (const ElementId id : chosen)
                expectEven(now, id);
            expectDart(now, cut, {0, 0});
            const BSpline2& outline = now.find<Patch>(left)->outline;
            for (const int edge : {0, 2, 3})
                expectStraight(outline, edge * unit, (edge + 1) * unit);
            expectStraight(outline, unit, 1.3 * unit);
            expectStraight(outline, 1.5 * unit, 2 * unit);
            EXPECT_EQ(now.find<Patch>(right)->outline, cut.find<Patch>(right)->outline);
        }
    }
}

TEST(EdgeTruing, TakesADartAlongWhereNothingElseCanMove)
{
    for (const bool cubic : {false, true}) {
        SCOPED_TRACE(cubic);
        const auto [design, unit] = sewnPanels(cubic);
        // Between two darts, the left one at the corner.
        Design cut = design.with(edits::addDart(design, {left, 0, 0.1 * unit, {15, 40}}));
        cut = cut.with(edits::addDart(cut, {left, 0.5 * unit, 0.6 * unit, {110, 40}}));
        ASSERT_EQ(dartsOf(cut).size(), 2u);
        const Stretch edge{left, 0.1 * unit, 0.5 * unit};
        ASSERT_NEAR(edits::edgeLength(cut, edge), 80, 1e-6);
        const Design shorter = cut.with(edits::setEdgeLengths(cut, std::array{Stretch{right, 0, unit}}, 84));
        Message problem;
        const std::array wanted{Stretch{right, 0, unit}, edge};
        const Design now = made(shorter, edits::makeEdgesEqual(shorter, wanted, &problem), problem);
        EXPECT_NEAR(edits::edgeLength(now, edge), 84, 1e-6);
        int alike = 0;
        for (const ElementId id : dartsOf(cut)) {
            const auto was = edits::dartOf(cut, id), is = edits::dartOf(now, id);
            ASSERT_TRUE(was && is) << "its legs are straight";
            const auto widthOf = [](const Design& in, const edits::DartShape& dart) {
                return edits::dartAxis(in.find<Patch>(dart.patch)->outline, dart).width;
            };
            EXPECT_NEAR(widthOf(now, *is), widthOf(cut, *was), 1e-6);
            const Seam &old = *cut.find<Seam>(id), &seam = *now.find<Seam>(id);
            EXPECT_NEAR(stretchLength(now, seam.a), stretchLength(cut, old.a), 1e-6);
            EXPECT_NEAR(stretchLength(now, seam.b), stretchLength(cut, old.b), 1e-6);
            alike += (is->tip - was->tip).norm() < 1e-9;
        }
        EXPECT_EQ(alike, 1) << "one of them has moved";
        for (const int other : {1, 2, 3})
            expectStraight(now.find<Patch>(left)->outline, other * unit, (other + 1) * unit);
    }
}

TEST(EdgeTruing, ADeepCurveBulgesAndAFlatOneIsMoved)
{
    for (const double depth : {60.0, 4.0}) {
        SCOPED_TRACE(depth);
        Design design = sewnPanels(true).design;
        Patch round = *design.find<Patch>(left);
        round.outline = BSpline2::withCorners({{0, 0},
                                               {66, 0},
                                               {133, 0},
                                               {200, 0},
                                               {200 + depth, 33},
                                               {200 + depth, 66},
                                               {200, 100},
                                               {133, 100},
                                               {66, 100},
                                               {0, 100},
                                               {0, 66},
                                               {0, 33}},
                                              {0, 3, 6, 9});
        design = with(design, left, round);
        Seam seam = *design.find<Seam>(between); // the curve is what changes
        std::swap(seam.a, seam.b);
        design = with(design, between, seam);
        const double length = stretchLength(design, seam.b);
        design = design.with(edits::setEdgeLengths(design, std::array{Stretch{right, 9, 12}}, length + 3));
        const Design now = sidesEqual(design, {between});
        expectEven(now, between);
        const BSpline2 &before = round.outline, &outline = now.find<Patch>(left)->outline;
        for (const int edge : {0, 2, 3})
            expectStraight(outline, 3 * edge, 3 * edge + 3);
        int still = 0;
        for (const double corner : before.corners())
            still += (before.at(corner) - outline.at(corner)).norm() < 1e-9;
        EXPECT_EQ(still, depth > 10 ? 4 : 3);
        if (depth > 10)
            continue;
        // In its own shape.
        const auto bendOf = [](const BSpline2& curve) {
            return cross(Vec2(curve.at(4.5) - curve.at(3)), Vec2(curve.at(6) - curve.at(3))) /
                   (curve.at(6) - curve.at(3)).squaredNorm();
        };
        EXPECT_NEAR(bendOf(outline), bendOf(before), 1e-9);
    }
}

TEST(EdgeTruing, OfADartLengthensTheSecondLegAlone)
{
    const Design design = twoPanels();
    const Design cut = design.with(edits::addDart(design, {left, 0.4, 0.5, {70, 50}}));
    const ElementId id = dartsOf(cut).front();
    const Seam& legs = *cut.find<Seam>(id);
    ASSERT_GT(stretchLength(cut, legs.b), stretchLength(cut, legs.a) + 5);
    const Design now = sidesEqual(cut, {id});
    expectEven(now, id);
    EXPECT_NEAR(stretchLength(now, legs.a), stretchLength(cut, legs.a), 1e-9);
    const auto was = edits::dartOf(cut, id), is = edits::dartOf(now, id);
    ASSERT_TRUE(is);
    EXPECT_TRUE(is->tip.isApprox(was->tip, 1e-9));
}

TEST(EdgeTruing, LeavesOtherSeamsAsLongAsTheyAre)
{
    // A trapezium whose left side runs on along the slope, and is sewn: only the right end may move.
    Design design = twoPanels();
    Patch patch = *design.find<Patch>(left);
    patch.outline = BSpline2(1, true, {{0, 0}, {200, 0}, {240, 100}, {-80, 100}});
    design = with(design, left, patch);
    Seam bottom, slope;
    bottom.a = {right, 2, 3};
    bottom.b = {left, 0, 1};
    slope.a = {left, 3, 4};
    slope.b = {right, 1, 2};
    design = with(with(design, ElementId(30), bottom), ElementId(31), slope);
    design = with(design, between, Seam{{left, 2, 3}, {right, 0, 1}});
    design = design.with(edits::setEdgeLengths(design, std::array{Stretch{right, 2, 3}}, 206));
    const Design now = sidesEqual(design, {ElementId(30)});
    expectEven(now, ElementId(30));
    EXPECT_TRUE(now.find<Patch>(left)->outline.points()[0].isApprox(Vec2(0, 0), 1e-9));
    EXPECT_TRUE(now.find<Patch>(left)->outline.points()[1].isApprox(Vec2(206, 0), 1e-6));
}

TEST(EdgeTruing, ATypedLengthBendsNothingElseEither)
{
    for (const bool cubic : {false, true}) {
        SCOPED_TRACE(cubic);
        const auto [design, unit] = sewnPanels(cubic);
        const Design cut = design.with(edits::addDart(design, {left, 0.5 * unit, 0.6 * unit, {110, 40}}));
        const Stretch edge{left, 0, 0.5 * unit};
        Message problem;
        const Design now = made(cut, edits::setEdgeLengths(cut, std::array{edge}, 110, &problem), problem);
        EXPECT_NEAR(edits::edgeLength(now, edge), 110, 1e-6);
        expectDart(now, cut, {5, 0});
        const BSpline2& outline = now.find<Patch>(left)->outline;
        EXPECT_TRUE(outline.at(0).isApprox(Vec2(-5, 0), 1e-9)) << "about its middle";
        expectStraight(outline, 0.6 * unit, unit);
        expectStraight(outline, 3 * unit, 4 * unit);
    }
}

} // namespace bolster
