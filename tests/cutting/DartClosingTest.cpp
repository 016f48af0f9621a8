#include "DartEdits.h"
#include "DartRotation.h"
#include "DesignCheck.h"
#include "DesignJson.h"
#include "FollowEdits.h"
#include "StretchLength.h"
#include "TwinEdits.h"
#include "Twins.h"

#include "Panels.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <random>

namespace bolster {

namespace {

using namespace test;

ElementId theDart(const Design& design)
{
    ElementId found = noElement;
    design.each<Seam>([&](ElementId id, const Seam&) { found = edits::dartOf(design, id) ? id : found; });
    return found;
}

/// With a seam, an allowance, a trim and a notch on each fifth of the left outline, or nothing there.
Design furnished(const BSpline2& outline)
{
    Design design = twoPanels();
    for (const ElementId id : {left, right}) {
        Patch patch = *design.find<Patch>(id);
        patch.outline = outline;
        design = with(design, id, patch);
    }
    const double start = outline.domainStart(), whole = outline.period();
    const auto at = [&](double share) { return start + share * whole; };
    Seam seam = *design.find<Seam>(between);
    seam.a = {left, at(0.05), at(0.3)};
    seam.b = {right, at(0.1), at(0.4)};
    seam.ease = 3;
    seam.zip = true;
    seam.step = 2;
    design = with(design, between, seam);
    FixationCurve rail;
    rail.curve = BSpline3(1, false, {{0, 0, 0}, {100, 0, 0}, {200, 0, 0}});
    design = with(design, ElementId(20), rail);
    FixationSeam held;
    held.stretch = {left, at(0.55), at(0.8)};
    held.curve = ElementId(20);
    design = with(design, ElementId(21), held);
    design = with(design, ElementId(22), EdgeAllowance{{left, at(0.05), at(0.3)}, 7});
    design = with(design, ElementId(23), EdgeAllowance{{left, at(0.31), at(0.9)}, 12});
    OutlineTrim trim;
    trim.stretch = {left, at(0.6), at(0.95)};
    trim.trim.pipingRadius = 3;
    design = with(design, ElementId(24), trim);
    design = with(design, ElementId(25), Notch{{left, at(0.97)}, {}});
    design = with(design, ElementId(26), CutCorner{{left, at(0.02)}, CornerJoin::Folded});
    return design;
}

std::optional<edits::DartShape> dartAt(const Design& design, double from, double width, double depth)
{
    const BSpline2& outline = design.find<Patch>(left)->outline;
    const auto to = edits::mouthEnd(outline, from, width, true);
    if (!to)
        return std::nullopt;
    edits::DartShape shape = edits::dartBetween(design, left, from, *to);
    const edits::DartAxis axis = edits::dartAxis(outline, shape);
    shape.tip = axis.middle + depth * axis.inwards;
    return shape;
}

BSpline2 turned(const BSpline2& outline, double start)
{
    std::vector<double> knots = outline.knots();
    for (double& knot : knots)
        knot += start;
    return {outline.degree(), true, outline.points(), std::move(knots)};
}

/// Both ends of a stretch, by places, so that it is the same wherever the outline is counted from.
void expectSame(const Design& before, const Design& now, const Stretch& a, const Stretch& b)
{
    EXPECT_EQ(a.patch, b.patch);
    const double period = before.find<Patch>(a.patch)->outline.period();
    EXPECT_NEAR(std::remainder(a.from - b.from, period), 0, 1e-6);
    EXPECT_NEAR(std::remainder(a.to - b.to, period), 0, 1e-6);
    EXPECT_NEAR(stretchLength(before, a), stretchLength(now, b), 1e-4);
}

void expectSameOutline(const BSpline2& before, const BSpline2& now)
{
    EXPECT_EQ(before.pointCount(), now.pointCount()) << "no control point is left over";
    EXPECT_EQ(before.corners().size(), now.corners().size());
    ASSERT_NEAR(before.period(), now.period(), 1e-9);
    for (int k = 0; k < 200; ++k) {
        const double t = before.domainStart() + before.period() * k / 200;
        EXPECT_LT((before.at(t) - now.at(now.wrapped(t))).norm(), 1e-4) << t;
    }
}

template <class T>
void expectSameKind(const Design& before, const Design& now, auto same)
{
    int count = 0;
    now.each<T>([&](ElementId, const T&) { ++count; });
    before.each<T>([&](ElementId id, const T& one) {
        --count;
        ASSERT_TRUE(now.find<T>(id));
        same(one, *now.find<T>(id));
    });
    EXPECT_EQ(count, 0) << "as many as before";
}

void expectSameDesign(const Design& before, const Design& now)
{
    const auto stretches = [&](const auto& a, const auto& b) { expectSame(before, now, a.stretch, b.stretch); };
    expectSameKind<Seam>(before, now, [&](const Seam& a, const Seam& b) {
        expectSame(before, now, a.a, b.a);
        expectSame(before, now, a.b, b.b);
        EXPECT_NEAR(a.ease, b.ease, 1e-9);
        EXPECT_EQ(a.trim, b.trim);
        EXPECT_TRUE(b.zip);
        EXPECT_EQ(a.step, b.step);
    });
    expectSameKind<EdgeAllowance>(before, now, [&](const EdgeAllowance& a, const EdgeAllowance& b) {
        stretches(a, b);
        EXPECT_EQ(a.width, b.width);
    });
    expectSameKind<OutlineTrim>(before, now, stretches);
    expectSameKind<FixationSeam>(before, now, [&](const FixationSeam& a, const FixationSeam& b) {
        stretches(a, b);
        EXPECT_EQ(a.curve, b.curve);
        EXPECT_EQ(a.curveRange, b.curveRange);
    });
    expectSameKind<Notch>(before, now, [&](const Notch& a, const Notch& b) {
        EXPECT_NEAR(std::remainder(a.place.at - b.place.at, before.find<Patch>(left)->outline.period()), 0, 1e-9);
    });
    expectSameKind<CutCorner>(before, now, [&](const CutCorner& a, const CutCorner& b) {
        EXPECT_NEAR(std::remainder(a.place.at - b.place.at, before.find<Patch>(left)->outline.period()), 0, 1e-9);
        EXPECT_EQ(a.join, b.join);
    });
}

void expectNoErrors(const Design& design)
{
    for (const Problem& problem : checkDesign(design))
        EXPECT_NE(problem.severity, Severity::Error) << problem.english();
    EXPECT_TRUE(readDesign(writeDesign(design)).design == design);
}

BSpline2 pentagon()
{
    return BSpline2(1, true, {{0, 0}, {300, 10}, {340, 160}, {150, 260}, {-20, 150}});
}

/// Few control points, so that a mouth lies between two knots or over one.
BSpline2 egg(int degree)
{
    std::vector<Vec2> points;
    for (int k = 0; k < 7; ++k) {
        const double angle = 2 * std::numbers::pi * k / 7;
        points.emplace_back(160 * std::cos(angle), 120 * std::sin(angle) + 10 * std::sin(2 * angle));
    }
    return BSpline2(degree, true, points);
}

/// Two curved edges between two corners, one straight one.
BSpline2 cushion()
{
    return BSpline2::withCorners(
        {{0, 0}, {100, -20}, {200, -20}, {300, 0}, {300, 65}, {300, 130}, {300, 200}, {200, 230}, {-30, 150}},
        {0, 3, 6});
}

std::vector<BSpline2> outlines()
{
    std::vector<BSpline2> all;
    for (const BSpline2& outline : {pentagon(), egg(2), egg(3), cushion()})
        for (const double start : {0.0, 1.75})
            for (const bool clockwise : {false, true})
                all.push_back(turned(clockwise ? outline.reversed() : outline, start));
    return all;
}

} // namespace

TEST(DartClosing, LeavesEverythingAsItWasBeforeTheDart)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0, 1), width(5, 25), depth(15, 45);
    int closed = 0;
    for (const BSpline2& outline : outlines()) {
        const Design before = furnished(outline);
        for (int k = 0; k < 25; ++k) {
            const double from = outline.wrapped(outline.domainStart() + share(random) * outline.period());
            const auto shape = dartAt(before, from, width(random), depth(random));
            Message problem;
            const Edit edit = shape ? edits::addDart(before, *shape, &problem) : Edit{};
            if (edit.empty())
                continue;
            // What lies or ends in the mouth is cut out with it.
            const auto inMouth = [&](double part) {
                const double t = outline.domainStart() + part * outline.period() - shape->from,
                             period = outline.period();
                const double span = shape->to - shape->from + (shape->to > shape->from ? 0 : period);
                return t - period * std::floor(t / period) <= span;
            };
            if (std::ranges::any_of(std::array{0.02, 0.05, 0.1, 0.3, 0.31, 0.4, 0.55, 0.6, 0.8, 0.9, 0.95, 0.97},
                                    inMouth))
                continue;
            const Design cut = before.with(edit);
            const Edit close = edits::removeDart(cut, theDart(cut), &problem);
            ASSERT_FALSE(close.empty()) << problem.english();
            SCOPED_TRACE(testing::Message() << outline.degree() << " points " << outline.pointCount() << " from "
                                            << from << " area " << outline.signedArea());
            ++closed;
            const Design now = cut.with(close);
            expectNoErrors(now);
            expectSameOutline(outline, now.find<Patch>(left)->outline);
            expectSameDesign(before, now);
            ASSERT_FALSE(testing::Test::HasFailure());
        }
    }
    EXPECT_GT(closed, 100);
}

TEST(DartClosing, AtACornerLeavesTheCorner)
{
    for (const BSpline2& outline : {pentagon(), cushion()}) {
        const Design before = furnished(outline);
        for (const double corner : outline.corners()) {
            const auto shape = dartAt(before, corner, 20, 30);
            const Edit edit = shape ? edits::addDart(before, *shape) : Edit{};
            if (edit.empty())
                continue;
            const Design cut = before.with(edit);
            const Design now = cut.with(edits::removeDart(cut, theDart(cut)));
            SCOPED_TRACE(corner);
            expectNoErrors(now);
            expectSameOutline(outline, now.find<Patch>(left)->outline);
        }
    }
}

TEST(DartClosing, OverManyKnotsIsASmoothPiece)
{
    std::vector<Vec2> points;
    for (int k = 0; k < 60; ++k)
        points.push_back(100 * Vec2(std::cos(k * std::numbers::pi / 30), std::sin(k * std::numbers::pi / 30)));
    for (const int degree : {2, 3}) {
        Design design = twoPanels();
        Patch round = *design.find<Patch>(left);
        round.outline = BSpline2(degree, true, points);
        design = with(design, left, round).with({{}, {{between, nullptr, nullptr}}});
        const auto shape = dartAt(design, 3.4, 40, 50);
        const Design cut = design.with(edits::addDart(design, *shape));
        const Design now = cut.with(edits::removeDart(cut, theDart(cut)));
        expectNoErrors(now);
        const BSpline2& outline = now.find<Patch>(left)->outline;
        EXPECT_TRUE(outline.corners().empty());
        EXPECT_LE(outline.pointCount(), round.outline.pointCount());
        for (int k = 0; k < 400; ++k) {
            const Vec2 at = outline.at(outline.domainStart() + outline.period() * k / 400);
            EXPECT_NEAR(at.norm(), 100, 0.5);
        }
    }
}

TEST(DartClosing, OnAStraightEdgeThatWasPulledLongerLeavesNoCorners)
{
    const Design design = twoPanels();
    Design cut = design.with(edits::addDart(design, {left, 0.4, 0.5, {90, 50}}));
    Patch pulled = *cut.find<Patch>(left);
    for (int k = 0; k < pulled.outline.pointCount(); ++k)
        if (pulled.outline.points()[static_cast<std::size_t>(k)].isApprox(Vec2(0, 0), 1e-9))
            pulled.outline = pulled.outline.withPoint(k, {-40, 0});
    cut = with(cut, left, pulled);
    const Design now = cut.with(edits::removeDart(cut, theDart(cut)));
    expectNoErrors(now);
    EXPECT_EQ(now.find<Patch>(left)->outline.pointCount(), 4);
    // Unless something begins on it.
    const Design noted = with(cut, ElementId(30), Notch{{left, 0.2}, {}});
    const Design kept = noted.with(edits::removeDart(noted, theDart(noted)));
    expectNoErrors(kept);
    const auto placeOf = [](const Design& in) {
        const BSpline2& outline = in.find<Patch>(left)->outline;
        return outline.at(outline.wrapped(in.find<Notch>(ElementId(30))->place.at));
    };
    EXPECT_TRUE(placeOf(noted).isApprox(placeOf(kept), 1e-9)) << "it stays where it is";
}

TEST(DartClosing, JoinsAnAllowanceThatWentOverTheMouth)
{
    const Design design = with(twoPanels(), ElementId(9), EdgeAllowance{{left, 0, 1}, 17});
    const Design cut = design.with(edits::addDart(design, {left, 0.4, 0.5, {90, 50}}));
    const Design now = cut.with(edits::removeDart(cut, theDart(cut)));
    int count = 0;
    now.each<EdgeAllowance>([&](ElementId, const EdgeAllowance&) { ++count; });
    EXPECT_EQ(count, 1);
    EXPECT_EQ(writeDesign(now), writeDesign(design)) << "nothing tells of the dart";
}

namespace {

/// How far the tangents turn beyond those at both ends of a part (unwrapped), degrees.
double mostBeyond(const BSpline2& outline, double from, double to)
{
    constexpr int count = 2000;
    const auto along = [&](double share) {
        const double t = from + share * (to - from), step = 1e-4 * (to - from);
        return Vec2(outline.at(outline.wrapped(t + step)) - outline.at(outline.wrapped(t)));
    };
    const auto turn = [](const Vec2& a, const Vec2& b) { return std::atan2(cross(a, b), a.dot(b)); };
    double angle = 0, least = 0, most = 0;
    for (int k = 0; k < count; ++k) {
        const double step = turn(along(static_cast<double>(k) / count), along((k + 1.0) / count));
        EXPECT_LT(std::abs(step), 0.05) << "a corner at " << from + k * (to - from) / count;
        angle += step;
        least = std::min(least, angle);
        most = std::max(most, angle);
    }
    const double beyond = std::max(std::min(0.0, angle) - least, most - std::max(0.0, angle));
    return beyond * 180 / std::numbers::pi;
}

Design undarted(const Design& design, ElementId seam)
{
    Message problem;
    const Edit edit = edits::removeDart(design, seam, &problem);
    EXPECT_FALSE(edit.empty()) << problem.english();
    const Design now = design.with(edits::withFollowers(design, edit));
    expectNoErrors(now);
    return now;
}

} // namespace

TEST(DartClosing, LeavesNoStepWhereADartWasTurnedOpen)
{
    const Design design = twoPanels();
    const Design cut = design.with(edits::addDart(design, {left, 0.4, 0.5, {90, 50}}));
    const ElementId seam = theDart(cut);
    // On the upper edge, beside the foot of the tip, and on the sides.
    for (const double to : {2.4, 2.5, 2.55, 2.6, 2.7, 3.5, 1.5}) {
        SCOPED_TRACE(to);
        const Edit rotation = edits::rotateDart(cut, seam, to);
        ASSERT_FALSE(rotation.empty());
        const Design turned = cut.with(rotation), now = undarted(turned, seam);
        const BSpline2 &open = turned.find<Patch>(left)->outline, &outline = now.find<Patch>(left)->outline;
        EXPECT_EQ(outline.corners().size(), open.corners().size() - 3) << "none of the dart is left";
        // From the corner before the mouth to that behind it.
        const auto mouth = edits::dartOf(turned, seam);
        double from = -1e9, end = 1e9;
        for (const double corner : outline.corners())
            for (int turn = -1; turn <= 2; ++turn) {
                const double t = corner + turn * outline.period();
                from = t < mouth->from ? std::max(from, t) : from;
                end = t > mouth->from ? std::min(end, t) : end;
            }
        EXPECT_LT(mostBeyond(outline, from + 1e-3, end - 1e-3), 25);
        EXPECT_GT(std::abs(outline.signedArea()), std::abs(open.signedArea())) << "the wedge is filled";
    }
}

TEST(DartClosing, WhereADartWasTurnedOpenInCurvesIsSmooth)
{
    int closed = 0;
    for (const BSpline2& outline : {egg(2), egg(3), egg(3).reversed(), cushion()})
        for (const double share : {0.05, 0.22, 0.63})
            for (const double to : {0.15, 0.35, 0.48, 0.8, 0.93}) {
                Design design = twoPanels();
                Patch patch = *design.find<Patch>(left);
                patch.outline = outline;
                design = with(design, left, patch).with({{}, {{between, nullptr, nullptr}}});
                const auto shape = dartAt(design, share * outline.period(), 14, 60);
                const Edit add = shape ? edits::addDart(design, *shape) : Edit{};
                const Design cut = design.with(add);
                const ElementId seam = theDart(cut);
                const Edit rotation =
                    seam == noElement ? Edit{} : edits::rotateDart(cut, seam, to * outline.period());
                if (rotation.empty())
                    continue;
                const Design turned = cut.with(rotation);
                SCOPED_TRACE(testing::Message() << outline.degree() << " " << share << " " << to);
                const Design now = undarted(turned, seam);
                // Legs at less than 30 degrees to the outline make a mouth that no curve leads over.
                const auto mouth = *edits::dartOf(turned, seam);
                const BSpline2& open = turned.find<Patch>(left)->outline;
                const Vec2 way = open.at(mouth.to) - open.at(mouth.from),
                           before = open.at(mouth.from) - open.at(open.wrapped(mouth.from - 1e-4));
                if (before.normalized().dot(way.normalized()) < 0.5)
                    continue;
                ++closed;
                EXPECT_EQ(now.find<Patch>(left)->outline.corners().size(), open.corners().size() - 3);
            }
    EXPECT_GT(closed, 10);
}

TEST(DartClosing, OfATwinThatWasTurnedOpenIsItsMirrorImage)
{
    Design design = twoPanels();
    design = design.with(edits::makeTwins(design, std::array{left}, [](const std::string& n) { return n + "'"; }));
    const auto make = [&](const Edit& edit) {
        ASSERT_FALSE(edit.empty());
        design = design.with(edits::withFollowers(design, edit));
    };
    make(edits::addDart(design, {left, 0.4, 0.5, {90, 50}}));
    const auto dartOfLeft = [&] {
        ElementId found = noElement;
        design.each<Seam>([&](ElementId id, const Seam& seam) {
            found = edits::dartOf(design, id) && seam.a.patch == left ? id : found;
        });
        return found;
    };
    make(edits::rotateDart(design, dartOfLeft(), 2.7));
    make(edits::removeDart(design, dartOfLeft()));
    expectNoErrors(design);
    EXPECT_EQ(theDart(design), noElement);
    const ElementId twin = twinOf(design, left);
    ASSERT_NE(twin, noElement);
    EXPECT_EQ(*mirroredCurve(design.find<Patch>(left)->outline), design.find<Patch>(twin)->outline);
}

} // namespace bolster
