#include "DartRotation.h"

#include "CuttingEdits.h"
#include "DartEdits.h"
#include "DesignCheck.h"
#include "DesignJson.h"
#include "FollowEdits.h"
#include "HandleEdits.h"
#include "OutlineCrossings.h"
#include "StretchLength.h"
#include "Symmetry.h"
#include "TwinEdits.h"
#include "Twins.h"

#include "Panels.h"

#include <gtest/gtest.h>

#include <numbers>

namespace bolster {

namespace {

using namespace test;

/// The bottom edge of the left panel, 20 mm wide, 50 mm deep, legs of one length.
const edits::DartShape deepDart{left, 0.4, 0.5, {90, 50}};

ElementId dartIn(const Design& design, ElementId patch)
{
    ElementId found = noElement;
    design.each<Seam>([&](ElementId id, const Seam&) {
        if (const auto dart = edits::dartOf(design, id); dart && dart->patch == patch)
            found = id;
    });
    return found;
}

double areaOfPatch(const Design& design, ElementId patch)
{
    return design.find<Patch>(patch)->outline.signedArea();
}

/// In all, and of each side of the seams but the dart's own.
std::pair<double, double> sewnLengths(const Design& design)
{
    std::pair<double, double> sum;
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        if (edits::dartOf(design, id))
            return;
        sum.first += stretchLength(design, seam.a);
        sum.second += stretchLength(design, seam.b);
    });
    return sum;
}

void expectGood(const Design& design)
{
    for (const Problem& problem : checkDesign(design))
        EXPECT_NE(problem.severity, Severity::Error) << problem.english();
    const ReadDesign read = readDesign(writeDesign(design));
    for (const Problem& problem : read.problems)
        EXPECT_NE(problem.severity, Severity::Error) << problem.english();
    EXPECT_TRUE(read.design == design);
}

/// An egg with seams all around, of every degree, either way round.
Design roundPanels(int degree, bool clockwise)
{
    Design design = twoPanels();
    for (const ElementId id : {left, right}) {
        Patch patch = *design.find<Patch>(id);
        std::vector<Vec2> points;
        const int count = degree == 1 ? 40 : 12;
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * k / count;
            points.emplace_back(100 * std::cos(angle), 80 * std::sin(angle) + 8 * std::sin(2 * angle));
        }
        patch.outline = BSpline2(degree, true, points);
        if (clockwise)
            patch.outline = patch.outline.reversed();
        design = with(design, id, patch);
    }
    const double whole = design.find<Patch>(left)->outline.period();
    Seam seam = *design.find<Seam>(between);
    seam.a = {left, 0.05 * whole, 0.45 * whole};
    seam.b = {right, 0.05 * whole, 0.45 * whole};
    return with(design, between, seam);
}

/// With equal legs, pointing at the middle.
Design withDart(const Design& design, double share, double depth)
{
    const BSpline2& outline = design.find<Patch>(left)->outline;
    const double from = outline.wrapped(share * outline.period());
    const auto to = edits::mouthEnd(outline, from, 15, true);
    edits::DartShape shape = edits::dartBetween(design, left, from, *to);
    const edits::DartAxis axis = edits::dartAxis(outline, shape);
    shape.tip = axis.middle + depth * axis.inwards;
    Message problem;
    const Edit edit = edits::addDart(design, shape, &problem);
    EXPECT_FALSE(edit.empty()) << problem.english();
    return design.with(edit);
}

} // namespace

TEST(DartRotation, OpensElsewhereByTheSameAngle)
{
    const Design design = twoPanels();
    const Design cut = design.with(edits::addDart(design, deepDart));
    const ElementId seam = dartIn(cut, left);
    // To the middle of the upper edge.
    const Edit edit = edits::rotateDart(cut, seam, 2.5);
    ASSERT_FALSE(edit.empty());
    const Design now = cut.with(edit);
    expectGood(now);
    EXPECT_NEAR(areaOfPatch(now, left), areaOfPatch(cut, left), 1e-6);
    const auto dart = edits::dartOf(now, seam);
    ASSERT_TRUE(dart) << "it is the seam that it was";
    EXPECT_TRUE(dart->tip.isApprox(deepDart.tip, 1e-9)) << "about its tip";
    const BSpline2& outline = now.find<Patch>(left)->outline;
    const Vec2 one = outline.at(dart->from) - dart->tip, two = outline.at(dart->to) - dart->tip;
    EXPECT_NEAR(one.norm(), std::hypot(10, 50), 1e-9);
    EXPECT_NEAR(two.norm(), one.norm(), 1e-9);
    const double angle = std::acos(one.dot(two) / one.norm() / two.norm());
    EXPECT_NEAR(angle, 2 * std::atan2(10, 50), 1e-9);
    EXPECT_EQ(writeDesign(now.with(edit.inverse())), writeDesign(cut));
}

TEST(DartRotation, KeepsAreaAndSeamsOnAllOutlines)
{
    int rotated = 0;
    for (const int degree : {1, 2, 3})
        for (const bool clockwise : {false, true})
            for (const double where : {0.02, 0.2, 0.6, 0.93})
                for (const double to : {0.03, 0.1, 0.25, 0.4, 0.5, 0.7, 0.85}) {
                    const Design cut = withDart(roundPanels(degree, clockwise), where, 45);
                    const double whole = cut.find<Patch>(left)->outline.period();
                    const ElementId seam = dartIn(cut, left);
                    Message problem;
                    const Edit edit = edits::rotateDart(cut, seam, to * whole, &problem);
                    ASSERT_NE(edit.empty(), problem.empty());
                    if (edit.empty())
                        continue;
                    SCOPED_TRACE(testing::Message() << degree << clockwise << " " << where << " " << to);
                    ++rotated;
                    const Design now = cut.with(edit);
                    expectGood(now);
                    EXPECT_NEAR(areaOfPatch(now, left), areaOfPatch(cut, left), 1e-6);
                    EXPECT_NEAR(sewnLengths(now).first, sewnLengths(cut).first, 1e-6);
                    EXPECT_NEAR(sewnLengths(now).second, sewnLengths(cut).second, 1e-6);
                    ASSERT_TRUE(edits::dartOf(now, seam));
                    EXPECT_TRUE(now.with(edit.inverse()) == cut);
                    EXPECT_TRUE(edits::withFollowers(cut, edit).changes.size() == edit.changes.size());
                }
    EXPECT_GT(rotated, 100);
}

TEST(DartRotation, LeavesNothingWhereItHasBeenInBetween)
{
    for (const int degree : {1, 2, 3})
        for (const bool clockwise : {false, true}) {
            const Design cut = withDart(roundPanels(degree, clockwise), 0.2, 45);
            const BSpline2& outline = cut.find<Patch>(left)->outline;
            const ElementId seam = dartIn(cut, left);
            const auto mouth = edits::dartOf(cut, seam);
            ASSERT_TRUE(mouth);
            const Design away = cut.with(edits::rotateDart(cut, seam, 0.62 * outline.period()));
            const BSpline2& there = away.find<Patch>(left)->outline;
            // Both ends of the mouth have met where it was.
            const Vec2 a = outline.at(outline.wrapped(mouth->from)), b = outline.at(outline.wrapped(mouth->to));
            const double atA = there.closest(a).parameter, atB = there.closest(b).parameter;
            const bool aStays = there.closest(a).distance < there.closest(b).distance;
            const Edit back = edits::rotateDart(away, seam, aStays ? atA : atB);
            ASSERT_FALSE(back.empty());
            const Design again = away.with(back);
            SCOPED_TRACE(testing::Message() << degree << clockwise);
            expectGood(again);
            EXPECT_EQ(again.find<Patch>(left)->outline.pointCount(), outline.pointCount());
            EXPECT_NEAR(areaOfPatch(again, left), areaOfPatch(cut, left), 1e-6);
        }
}

TEST(DartRotation, TakesMarksHolesAndLabelsAlong)
{
    Design design = twoPanels();
    design = design.with(edits::addDart(design, deepDart));
    const ElementId seam = dartIn(design, left), notch = design.nextId();
    design = design.with(edits::addNotch(design, {left, 1.5}, {})); // right edge
    const ElementId far = design.nextId();
    design = design.with(edits::addNotch(design, {left, 3.5}, {})); // left edge
    const ElementId hole = design.nextId();
    design = design.with(edits::addDrillHole(design, {left, {180, 50}}, "Hole"));
    design = design.with(edits::setLabel(design, left, PieceLabelPlace{{160, 30}, 0}));
    // Between dart and upper right corner lies the shorter way: it turns.
    const Design now = design.with(edits::rotateDart(design, seam, 2.1));
    expectGood(now);
    const auto placeOf = [](const Design& in, ElementId id) {
        const OutlinePlace& place = in.find<Notch>(id)->place;
        const BSpline2& outline = in.find<Patch>(place.patch)->outline;
        return outline.at(outline.wrapped(place.at));
    };
    const Vec2 tip = deepDart.tip;
    const Eigen::Rotation2Dd turn(-2 * std::atan2(10, 50));
    EXPECT_TRUE(placeOf(now, notch).isApprox(tip + turn * (Vec2(200, 50) - tip), 1e-6))
        << placeOf(now, notch).transpose();
    EXPECT_TRUE(placeOf(now, far).isApprox(Vec2(0, 50), 1e-6)) << "the other part stays";
    EXPECT_TRUE(now.find<DrillHole>(hole)->place.position.isApprox(tip + turn * (Vec2(180, 50) - tip), 1e-9));
    EXPECT_TRUE(now.find<Patch>(left)->cutting.label->position.isApprox(tip + turn * (Vec2(160, 30) - tip), 1e-9));
    EXPECT_NEAR(now.find<Patch>(left)->cutting.label->rotation, turn.angle() * 180 / std::numbers::pi, 1e-9);
    double end = 0;
    now.each<Seam>([&](ElementId id, const Seam& sewn) {
        if (id != seam)
            end += stretchLength(now, sewn.a) - stretchLength(now, sewn.b);
    });
    EXPECT_NEAR(end, 0, 1e-6) << "the right edge is still sewn whole";
    // And so on, whatever is done with the dart then.
    for (const Edit& edit : {edits::moveDartTip(now, seam, {95, 45}), edits::removeDart(now, seam),
                             edits::moveDart(now, seam, 3.25)}) {
        ASSERT_FALSE(edit.empty());
        SCOPED_TRACE(edit.verb.english());
        const Design then = now.with(edit);
        expectGood(then);
        ASSERT_TRUE(then.find<Notch>(far) && then.find<Notch>(notch));
        EXPECT_TRUE(placeOf(then, far).isApprox(Vec2(0, 50), 1e-6));
        EXPECT_TRUE(placeOf(then, notch).isApprox(placeOf(now, notch), 1e-6));
    }
}

TEST(DartRotation, LeavesWhatIsDrawnWhereItBelongs)
{
    Design design = twoPanels();
    design = design.with(edits::addDart(design, deepDart));
    const ElementId seam = dartIn(design, left), line = design.nextId();
    const auto draw = [&](const Vec2& a, const Vec2& b) {
        return design.with(edits::addInternalLine(design, left, BSpline2(1, false, {a, b}), {}, "Line"));
    };
    const Vec2 tip = deepDart.tip;
    const Eigen::Rotation2Dd turn(-2 * std::atan2(10, 50));
    {
        const Design drawn = draw({150, 20}, {200, 60}); // ends on the edge that turns
        const Edit edit = edits::rotateDart(drawn, seam, 2.1);
        const Design now = drawn.with(edits::withFollowers(drawn, edit));
        const auto& points = now.find<InternalLine>(line)->curve.points();
        EXPECT_TRUE(points[0].isApprox(tip + turn * (Vec2(150, 20) - tip), 1e-9));
        EXPECT_TRUE(points[1].isApprox(tip + turn * (Vec2(200, 60) - tip), 1e-9));
    }
    {
        const Design drawn = draw({0, 30}, {40, 60});
        const Design now = drawn.with(edits::withFollowers(drawn, edits::rotateDart(drawn, seam, 2.1)));
        for (std::size_t k = 0; k < 2; ++k)
            EXPECT_TRUE(now.find<InternalLine>(line)->curve.points()[k].isApprox(
                drawn.find<InternalLine>(line)->curve.points()[k], 1e-9));
    }
    Message problem;
    EXPECT_TRUE(edits::rotateDart(draw({60, 80}, {190, 80}), seam, 2.3, &problem).empty());
    EXPECT_NE(problem.english().find("Line"), std::string::npos) << "it lies across the new dart";
}

TEST(DartRotation, IsRefusedWhereItCannotBe)
{
    const Design design = twoPanels();
    Message problem;
    EXPECT_TRUE(edits::rotateDart(design, between, 2.5, &problem).empty());
    EXPECT_FALSE(problem.empty());
    const Design uneven = design.with(edits::addDart(design, {left, 0.4, 0.5, {60, 50}}));
    problem = {};
    EXPECT_TRUE(edits::rotateDart(uneven, dartIn(uneven, left), 2.5, &problem).empty());
    EXPECT_NE(problem.english().find("one length"), std::string::npos);
    const Design cut = design.with(edits::addDart(design, deepDart));
    problem = {};
    EXPECT_TRUE(edits::rotateDart(cut, dartIn(cut, left), 0.5, &problem).empty());
    EXPECT_NE(problem.english().find("5 mm"), std::string::npos) << "where it is already";
    // An L: the inner corner is between the tip and the far arm.
    Patch bent = *design.find<Patch>(left);
    bent.outline = BSpline2(1, true, {{0, 0}, {200, 0}, {200, 50}, {50, 50}, {50, 200}, {0, 200}});
    Design corner = with(design, left, bent).with({{}, {{between, nullptr, nullptr}}});
    corner = corner.with(edits::addDart(corner, {left, 0.7, 0.75, {145, 30}}));
    problem = {};
    EXPECT_TRUE(edits::rotateDart(corner, dartIn(corner, left), 4.5, &problem).empty());
    EXPECT_NE(problem.english().find("would leave"), std::string::npos) << problem.english();
}

TEST(DartRotation, OfATwinIsItsMirrorImage)
{
    Design design = twoPanels();
    design = design.with(edits::makeTwins(design, std::array{left}, [](const std::string& n) { return n + "'"; }));
    const ElementId twin = twinOf(design, left);
    const auto make = [&](const Edit& edit) { design = design.with(edits::withFollowers(design, edit)); };
    make(edits::addDart(design, deepDart));
    for (const Vec2& place : {Vec2(100, 100), Vec2(0, 50), Vec2(200, 50)}) {
        const double to = design.find<Patch>(left)->outline.closest(place).parameter;
        Message problem;
        const Edit edit = edits::rotateDart(design, dartIn(design, left), to, &problem);
        ASSERT_FALSE(edit.empty()) << problem.english();
        make(edit);
        expectGood(design);
        EXPECT_EQ(twinOf(design, left), twin) << "they stay twins";
        EXPECT_NEAR(std::abs(areaOfPatch(design, twin)), areaOfPatch(design, left), 1e-6);
        const auto one = edits::dartOf(design, dartIn(design, left)),
                   other = edits::dartOf(design, dartIn(design, twin));
        ASSERT_TRUE(one);
        ASSERT_TRUE(other);
        EXPECT_NEAR(one->from, other->from, 1e-9);
        EXPECT_TRUE(other->tip.isApprox(mirroredInOutline(one->tip), 1e-9));
    }
    make(edits::moveDartTip(design, dartIn(design, left), {100, 45}));
    expectGood(design);
    make(edits::removeDart(design, dartIn(design, left)));
    expectGood(design);
    EXPECT_EQ(dartIn(design, left), noElement);
    EXPECT_EQ(dartIn(design, twin), noElement);
}

} // namespace bolster
