#include "FixationEdits.h"
#include "ArcLength.h"
#include "CurveEdits.h"
#include "DesignCheck.h"
#include "ElementEdits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bolster::fixing { // names that other tests have, too
namespace {

using namespace edits;

constexpr ElementId leather{1}, seat{2}, rail{3}, hoop{4}, second{5};
constexpr double side = 200;

/// The cover of the square bends about the y axis, without stretch: an arc of radius 300.
Vec3 placeOf(const Vec2& p)
{
    constexpr double radius = 300;
    return {radius * std::sin(p.x() / radius), p.y(), radius * std::cos(p.x() / radius)};
}

SurfaceMesh bentSquare()
{
    constexpr std::uint32_t cells = 40;
    auto topology = std::make_shared<SurfaceTopology>();
    SurfaceMesh mesh;
    for (std::uint32_t j = 0; j <= cells; ++j)
        for (std::uint32_t i = 0; i <= cells; ++i) {
            topology->pattern.emplace_back(side * i / cells, side * j / cells);
            mesh.positions.push_back(placeOf(topology->pattern.back()));
        }
    for (std::uint32_t j = 0; j < cells; ++j)
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t a = j * (cells + 1) + i, b = a + cells + 1;
            topology->triangles.push_back({a, a + 1, b + 1});
            topology->triangles.push_back({a, b + 1, b});
        }
    topology->patches.push_back({seat, leather, 0, topology->vertexCount(), 0, 2 * cells * cells, 0});
    mesh.topology = topology;
    return mesh;
}

BSpline3 straight(const Vec3& from, const Vec3& to)
{
    return BSpline3(1, false, {from, to});
}

class FixationEditsTest : public testing::Test {
protected:
    FixationEditsTest()
    {
        Patch patch;
        patch.name = "Seat";
        patch.fabric = leather;
        patch.outline = BSpline2(1, true, {{0, 0}, {side, 0}, {side, side}, {0, side}});
        std::vector<Vec3> around;
        for (int k = 0; k < 8; ++k)
            around.emplace_back(100 + 150 * std::cos(k * std::numbers::pi / 4),
                                100 + 150 * std::sin(k * std::numbers::pi / 4), 280);
        Edit edit;
        edit.changes = {
            {leather, nullptr, makeElement(Fabric{"Leather"})},
            {seat, nullptr, makeElement(patch)},
            {rail, nullptr, makeElement(FixationCurve{"Rail", straight({190, -5, 240}, {0, -5, 300})})},
            {hoop, nullptr, makeElement(FixationCurve{"Hoop", BSpline3(3, true, around)})},
            {second, nullptr, makeElement(FixationCurve{"Second", straight({0, -5, 300}, {100, -5, 290})})}};
        design = Design().with(edit);
    }

    /// The only fixation seams of the design after an edit that must be sound and undo to the same design.
    std::vector<FixationSeam> seamsAfter(const Edit& edit) const
    {
        const Design after = design.with(edit);
        EXPECT_EQ(after.with(edit.inverse()), design);
        for (const Problem& problem : checkDesign(after))
            if (problem.severity == Severity::Error)
                ADD_FAILURE() << problem.english();
        std::vector<FixationSeam> seams;
        after.each<FixationSeam>([&](ElementId, const FixationSeam& seam) { seams.push_back(seam); });
        return seams;
    }

    Design design;
    const SurfaceMesh surface = bentSquare();
};

TEST_F(FixationEditsTest, ACurveIsMadeWhereTheStretchLies)
{
    const Edit edit = addFixationFromSurface(design, surface, {seat, 0.25, 1}, "Front");
    const std::vector<FixationSeam> seams = seamsAfter(edit);
    ASSERT_EQ(seams.size(), 1u);
    ASSERT_EQ(edit.changes.size(), 2u);
    EXPECT_EQ(seams[0].curve, edit.changes.front().id);
    EXPECT_EQ(seams[0].stretch, (Stretch{seat, 0.25, 1}));
    EXPECT_FALSE(seams[0].reversed);
    EXPECT_EQ(edit.verb.english(), "Create fixation curve Front");
    const BSpline3 curve = std::get<FixationCurve>(*edit.changes.front().after).curve;
    EXPECT_EQ(curve.degree(), 3);
    EXPECT_LE(curve.pointCount(), 8);
    for (double t = 0.25; t <= 1; t += 0.05)
        EXPECT_LT((curve.at(t) - placeOf({side * t, 0})).norm(), 0.3) << t;
}

TEST_F(FixationEditsTest, AStretchOverTheStartAndAroundACornerIsFollowed)
{
    const Edit edit = addFixationFromSurface(design, surface, {seat, 3.5, 0.5}, "Corner");
    const std::vector<FixationSeam> seams = seamsAfter(edit);
    ASSERT_EQ(seams.size(), 1u);
    const BSpline3 curve = std::get<FixationCurve>(*edit.changes.front().after).curve;
    EXPECT_LT((curve.at(curve.domainStart()) - placeOf({0, side / 2})).norm(), 0.1);
    EXPECT_LT((curve.at(curve.domainEnd()) - placeOf({side / 2, 0})).norm(), 0.1);
    EXPECT_LT(curve.closest(placeOf({0, 0})).distance, 0.1);
}

TEST_F(FixationEditsTest, AWholeOutlineGivesAClosedCurve)
{
    const Edit edit = addFixationFromSurface(design, surface, {seat, 1, 1}, "Around");
    const std::vector<FixationSeam> seams = seamsAfter(edit);
    ASSERT_EQ(seams.size(), 1u);
    const BSpline3 curve = std::get<FixationCurve>(*edit.changes.front().after).curve;
    EXPECT_TRUE(curve.closed());
    ASSERT_TRUE(seams[0].curveRange) << "it begins at another corner than the curve";
    EXPECT_LT((curve.at(seams[0].curveRange->first) - placeOf({side, 0})).norm(), 0.1);
}

TEST_F(FixationEditsTest, WhatIsFixedIsNotFixedTwice)
{
    design = design.with(addFixationFromSurface(design, surface, {seat, 0, 1}, "Front"));
    const auto problem = fixationProblem(design, {seat, 0.5, 2});
    ASSERT_TRUE(problem);
    EXPECT_NE(problem->english().find("fixed to Front already"), std::string::npos);
    EXPECT_TRUE(addFixationFromSurface(design, surface, {seat, 0.5, 2}, "More").empty());
    EXPECT_TRUE(attachStretch(design, {seat, 3.5, 0.5}, rail, nullptr).empty());
    EXPECT_TRUE(attachStretch(design, {seat, 2, 2}, rail, nullptr).empty());
    EXPECT_FALSE(fixationProblem(design, {seat, 1, 2})) << "stretches may meet";
    EXPECT_FALSE(fixationProblem(design, {seat, 3, 0})) << "stretches may meet";
}

TEST_F(FixationEditsTest, ImpossibleStretchesAreRefused)
{
    EXPECT_TRUE(fixationProblem(design, {ElementId{99}, 0, 1}));
    EXPECT_TRUE(fixationProblem(design, {seat, std::nan(""), 1}));
    EXPECT_TRUE(fixationProblem(design, {seat, 0, 1e-6}));
    EXPECT_TRUE(addFixationFromSurface(design, {}, {seat, 0, 1}, "").empty());
    EXPECT_TRUE(attachStretch(design, {seat, 0, 1}, seat, &surface).empty()) << "a patch is no curve";
    EXPECT_TRUE(attachStretches(design, {}, rail, &surface).empty());
}

TEST_F(FixationEditsTest, TheSurfaceTellsTheDirection)
{
    const std::vector<FixationSeam> guessed = seamsAfter(attachStretch(design, {seat, 0, 1}, rail, &surface));
    ASSERT_EQ(guessed.size(), 1u);
    EXPECT_TRUE(guessed[0].reversed) << "the rail runs against the outline";
    EXPECT_FALSE(guessed[0].curveRange);
    const Edit blind = attachStretch(design, {seat, 0, 1}, rail, nullptr);
    EXPECT_FALSE(seamsAfter(blind).front().reversed);
    EXPECT_EQ(blind.verb.english(), "Attach Seat to Rail");
}

TEST_F(FixationEditsTest, ACornerThatIsHeldTellsTheDirection)
{
    const SurfaceMesh surface = bentSquare(); // it hangs somewhere else: the other way round would be nearer
    design = design.with(attachStretch(design, {seat, 0, 1}, rail, nullptr)); // corner 1 is held at (0, -5, 300)
    for (const bool fromTheCorner : {true, false}) {
        const Vec3 held(0, -5, 300), other(200, 300, 0);
        Edit drawn;
        drawn.changes = {
            {second, nullptr,
             makeElement(FixationCurve{"Second", fromTheCorner ? straight(held, other) : straight(other, held)})}};
        const Design both = design.with(drawn);
        const Design after = both.with(attachStretch(both, {seat, 1, 2}, second, &surface));
        after.each<FixationSeam>([&](ElementId, const FixationSeam& seam) {
            EXPECT_TRUE(seam.curve != second || seam.reversed != fromTheCorner);
        });
    }
}

TEST_F(FixationEditsTest, OfAClosedCurveTheNearestPartIsTaken)
{
    const std::vector<FixationSeam> seams = seamsAfter(attachStretch(design, {seat, 0, 1}, hoop, &surface));
    ASSERT_EQ(seams.size(), 1u);
    ASSERT_TRUE(seams[0].curveRange);
    const BSpline3& curve = design.find<FixationCurve>(hoop)->curve;
    EXPECT_LT(curve.at(seams[0].curveRange->first).x(), 60);
    EXPECT_GT(curve.at(seams[0].curveRange->second).x(), 140);
    EXPECT_LT(curve.at(seams[0].curveRange->second).y(), 80);
    EXPECT_FALSE(seams[0].reversed);
}

TEST_F(FixationEditsTest, AFixedStretchIsAttachedAnew)
{
    design = design.with(attachStretch(design, {seat, 0, 1}, rail, &surface));
    const std::vector<FixationSeam> seams = seamsAfter(attachStretch(design, {seat, 0, 1}, second, &surface));
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_EQ(seams[0].curve, second);
    EXPECT_TRUE(attachStretch(design, {seat, 0, 1}, rail, &surface).empty()) << "nothing changes";
}

TEST_F(FixationEditsTest, SeveralStretchesShareACurveInTheOrderOfTheSurface)
{
    const Stretch stretches[] = {{seat, 0, 0.25}, {seat, 0.25, 1}};
    const std::vector<FixationSeam> seams = seamsAfter(attachStretches(design, stretches, rail, &surface));
    ASSERT_EQ(seams.size(), 2u);
    ASSERT_TRUE(seams[0].curveRange && seams[1].curveRange);
    const BSpline3& curve = design.find<FixationCurve>(rail)->curve;
    // The rail begins at the far end, so the longer stretch comes first.
    for (const FixationSeam& seam : seams) {
        EXPECT_TRUE(seam.reversed);
        const bool longer = seam.stretch.from == 0.25;
        EXPECT_NEAR(seam.curveRange->first, longer ? 0 : 0.75, 1e-6);
        EXPECT_NEAR(seam.curveRange->second, longer ? 0.75 : curve.domainEnd(), 1e-6);
    }
    const Stretch overlapping[] = {{seat, 0, 0.5}, {seat, 0.25, 1}};
    EXPECT_TRUE(attachStretches(design, overlapping, rail, &surface).empty());
}

TEST_F(FixationEditsTest, ARowOnAClosedCurveBeginsAtItsCorner)
{
    const BSpline3 square(1, true, {{-30, 0, 290}, {170, 0, 290}, {170, 200, 290}, {-30, 200, 290}});
    const Edit added = addElement(design, makeElement(FixationCurve{"Edge", square}));
    design = design.with(added);
    const Stretch edges[] = {{seat, 0, 1}, {seat, 1, 2}, {seat, 2, 3}, {seat, 3, 0}};
    const std::vector<FixationSeam> seams =
        seamsAfter(attachStretches(design, edges, added.changes.front().id, &surface));
    ASSERT_EQ(seams.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
        ASSERT_TRUE(seams[k].curveRange);
        EXPECT_NEAR(seams[k].curveRange->first, static_cast<double>(k), 1e-6);
        EXPECT_FALSE(seams[k].reversed);
    }
}

TEST_F(FixationEditsTest, OneStretchIsDividedAmongCurves)
{
    design = design.with(attachStretch(design, {seat, 0, 1}, rail, &surface));
    const ElementId curves[] = {rail, second};
    const std::vector<FixationSeam> seams = seamsAfter(attachToCurves(design, {seat, 0, 1}, curves, &surface));
    ASSERT_EQ(seams.size(), 2u);
    const double a = ArcLength3(design.find<FixationCurve>(rail)->curve).total();
    const double b = ArcLength3(design.find<FixationCurve>(second)->curve).total();
    EXPECT_EQ(seams[0].curve, second) << "it is nearer to the start";
    EXPECT_FALSE(seams[0].reversed);
    EXPECT_NEAR(seams[0].stretch.to, b / (a + b), 1e-6);
    EXPECT_EQ(seams[1].curve, rail);
    EXPECT_TRUE(seams[1].reversed);
    EXPECT_EQ(seams[1].stretch.from, seams[0].stretch.to);
    EXPECT_EQ(seams[1].stretch.to, 1);
}

TEST(LeadingCurvesOn, GoesAlongTheWayAndKeepsEveryPlace)
{
    const std::vector<Vec3> through{{0, 0, 0}, {40, 10, 5}, {90, -10, 0}, {130, 0, 10}, {170, 20, 0}};
    std::vector<Vec3> way;
    for (int k = 0; k <= 12; ++k)
        way.emplace_back(170 + 5 * k, 20 + 30 * std::sin(0.1 * k), 3 * k);
    const BSpline3 straight(1, false, through), smooth(3, false, through);
    for (const BSpline3& curve : {straight, smooth, BSpline3(2, false, through), smooth.reversed()}) {
        const Vec3 meets =
            (curve.points().front() - way.front()).norm() < 1e-9 ? curve.points().front() : curve.points().back();
        Design design = Design().with({{}, {{rail, nullptr, makeElement(FixationCurve{"Rail", curve})}}});
        design = design.with(leadCurveOn(design, rail, way));
        const BSpline3& longer = design.find<FixationCurve>(rail)->curve;
        EXPECT_EQ(longer.pointCount(), curve.pointCount() + curve.degree());
        for (int k = 0; k <= 40; ++k) {
            const double at = curve.domainStart() + curve.period() * k / 40;
            EXPECT_LT((longer.at(at) - curve.at(at)).norm(), 1e-9);
        }
        const bool atFront = (longer.points().front() - way.back()).norm() < 1e-9;
        EXPECT_EQ(atFront, meets == curve.points().front());
        EXPECT_LT(((atFront ? longer.points().front() : longer.points().back()) - way.back()).norm(), 1e-9);
        for (const Vec3& place : way)
            EXPECT_LT(longer.closest(place).distance, curve.degree() == 1 ? 10 : 1);
    }
}

TEST(LeadingCurvesOn, WhatIsFixedToAllOfTheCurveStaysWhereItWas)
{
    const BSpline3 curve(1, false, {{0, 0, 0}, {200, 0, 0}});
    FixationSeam fixed;
    fixed.curve = rail;
    Design design = Design().with(
        {{}, {{rail, nullptr, makeElement(FixationCurve{"Rail", curve})}, {hoop, nullptr, makeElement(fixed)}}});
    const std::vector<Vec3> way{{200, 0, 0}, {260, 0, 0}};
    design = design.with(leadCurveOn(design, rail, way));
    EXPECT_EQ(design.find<FixationSeam>(hoop)->curveRange, std::pair(0.0, 1.0));
    EXPECT_TRUE(leadCurveOn(design, rail, std::span(way).first(1)).empty());
    const BSpline3 ring(1, true, {{0, 0, 0}, {200, 0, 0}, {0, 100, 0}});
    design = design.with({{}, {{second, nullptr, makeElement(FixationCurve{"Ring", ring})}}});
    EXPECT_TRUE(leadCurveOn(design, second, way).empty()) << "a ring has no end";
}

} // namespace
} // namespace bolster::fixing
