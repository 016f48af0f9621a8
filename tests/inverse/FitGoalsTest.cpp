// Goals of a fit beside a form and strain: no folds, a seam along a curve, a patch of another size.
#include "ArcLength.h"
#include "CoverStrains.h"
#include "FitRows.h"
#include "PatternFit.h"
#include "PatternLocator.h"
#include "TestFreedoms.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bolster::test {
namespace {

constexpr double coarseEdge = 25; // mm, so that a fit takes a second

FitOrder orderFor(const Design& design)
{
    FitOrder order;
    order.goals.keepShape = FitGoals::lightly;
    order.freedoms = outlineFreedoms(design);
    return order;
}

ElementId firstPatch(const Design& design)
{
    ElementId found = noElement;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        if (found == noElement && !patch.twin)
            found = id;
    });
    return found;
}

double patchArea(const Design& design, ElementId patch)
{
    return std::abs(design.find<Patch>(patch)->outline.signedArea());
}

/// As it is seen: the map shows principal strains, in colours that know no grain.
TEST(FitGoals, OneLimitHoldsInEveryDirection)
{
    const Design design = coarseSample("box-cushion", coarseEdge);
    SurfaceTopology flat;
    flat.pattern = {Vec2(0, 0), Vec2(10, 0), Vec2(0, 10)};
    flat.triangles = {{0, 1, 2}};
    flat.patches = {{.patch = firstPatch(design), .firstTriangle = 0, .triangleCount = 1}};
    const auto areaOver = [&](const Eigen::Matrix2d& map) {
        std::vector<Vec3> places;
        for (const auto& at : flat.pattern)
            places.emplace_back(map(0, 0) * at.x() + map(0, 1) * at.y(), map(1, 0) * at.x() + map(1, 1) * at.y(),
                                0);
        return overLimit(coverStrains(flat, places, design, 2)).area;
    };
    const auto symmetric = [](double x, double y, double shear) {
        return (Eigen::Matrix2d() << 1 + x, shear / 2, shear / 2, 1 + y).finished();
    };
    EXPECT_EQ(areaOver(symmetric(0.021, 0, 0)), 1);
    EXPECT_EQ(areaOver(symmetric(0, -0.021, 0)), 1);
    EXPECT_EQ(areaOver(symmetric(0.019, -0.019, 0)), 0);
    EXPECT_EQ(areaOver(symmetric(0, 0, 0.038)), 0) << "1.9 % on the bias, whatever angle threads take";
    EXPECT_EQ(areaOver(symmetric(0, 0, 0.042)), 1);
    EXPECT_EQ(areaOver(symmetric(0.012, 0.012, 0.02)), 1) << "2.2 % on the bias, less along every thread";
}

/// Whoever looks at the pattern does not see whether an edge is straight to a twentieth of a millimetre.
TEST(FitGoals, EdgesThatLookStraightKeepTheirBow)
{
    const auto square = [](double bow) {
        constexpr double side = 400;
        const std::vector<Vec2> points{{0, 0},       {130, -bow}, {270, -bow}, {side, 0}, {side, 130}, {side, 270},
                                       {side, side}, {270, side}, {130, side}, {0, side}, {0, 270},    {0, 130}};
        Patch patch;
        patch.outline = BSpline2::withCorners(points, {0, 3, 6, 9});
        return Design().with({{}, {{ElementId{1}, nullptr, makeElement(std::move(patch))}}});
    };
    const auto cost = [&](double before, double after, bool locked) {
        FitLocks locks;
        locks.straight = locked;
        const FitGoals none;
        const Design design = square(before);
        return FitRows(none, locks, design).rows(SurfaceTopology(), {}, square(after)).squaredNorm();
    };
    EXPECT_EQ(cost(0.5, 0.5, true), 0);
    EXPECT_NEAR(cost(0.5, 1.5, true), cost(0, 1, true), 1e-9);
    EXPECT_GT(cost(0.5, 1.5, true), 1);
    EXPECT_EQ(cost(0.5, 1.5, false), 0);
    EXPECT_EQ(cost(3, 4, true), 0) << "that is seen to be bent";
}

/// Else what is too tight is eased by faces going slack.
TEST(FitGoals, ClothThatIsPressedTogetherCountsSoonerThanStretch)
{
    const Design design = coarseSample("box-cushion", coarseEdge);
    FitGoals goals;
    goals.strain = true;
    goals.limit = 2;
    goals.keepShape = 0;
    FitRows rows(goals, {}, design);
    WarmOrder order;
    order.edgeLength = coarseEdge;
    const WarmCover cover(SolveInput(design, {}), order);
    ASSERT_TRUE(cover.hasHome());
    rows.aim(cover);
    const SurfaceTopology& topology = *cover.mesh().topology;
    const auto cost = [&](double strain) {
        std::vector<Vec3> places;
        for (const auto& at : topology.pattern)
            places.emplace_back((1 + strain) * at.x(), (1 + strain) * at.y(), 0);
        return rows.rows(topology, places, design).squaredNorm();
    };
    EXPECT_NEAR(cost(0.013), cost(0), 1e-6);
    EXPECT_GT(cost(-0.013), cost(0) + 0.01);
    EXPECT_GT(cost(0.018), cost(0) + 0.01);
}

TEST(FitGoals, APatchGetsTheSizeThatIsWanted)
{
    const Design design = coarseSample("box-cushion", coarseEdge);
    const ElementId patch = firstPatch(design);
    FitOrder order = orderFor(design);
    order.goals.sizes = {{patch, 0.95}};
    const FitResult result = fitPattern(design, order);
    ASSERT_EQ(result.status, FitResult::Status::Done) << result.reason.english();
    EXPECT_NEAR(result.before.sizeMost, 1 / 0.95 - 1, 1e-9);
    EXPECT_LT(result.after.sizeMost, 0.01);
    EXPECT_NEAR(patchArea(result.design, patch) / patchArea(design, patch), 0.95, 0.01);
    EXPECT_LT(result.after.sewnMost, 0.5) << "what is sewn to it goes with it";
}

TEST(FitGoals, WhatIsMeasuredOfAllOfAChangeIsWhatTheFitReached)
{
    const Design design = coarseSample("box-cushion", coarseEdge);
    FitOrder order = orderFor(design);
    order.goals.sizes = {{firstPatch(design), 0.95}};
    const FitResult result = fitPattern(design, order);
    ASSERT_EQ(result.status, FitResult::Status::Done) << result.reason.english();
    const auto whole = measureChange(design, order, result.design);
    ASSERT_TRUE(whole);
    EXPECT_NEAR(whole->after.sizeMost, result.after.sizeMost, 1e-9);
    EXPECT_NEAR(whole->after.shapeRms, result.after.shapeRms, 1e-3);
    const auto half = measureChange(design, order, withFreedoms(design, order.freedoms, 0.5 * result.values));
    ASSERT_TRUE(half);
    EXPECT_NEAR(half->before.sizeMost, result.before.sizeMost, 1e-9);
    EXPECT_GT(half->after.sizeMost, whole->after.sizeMost + 0.01);
    EXPECT_LT(half->after.shapeRms, whole->after.shapeRms);
    EXPECT_GT(half->after.shapeRms, 0.2 * whole->after.shapeRms);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(measureChange(design, order, result.design, stop.get_token()));
}

TEST(FitGoals, ASeamGoesToItsCurve)
{
    const Design design = coarseSample("box-cushion", coarseEdge);
    const SolveResult cover = solved(design, 1e-6);
    ASSERT_TRUE(cover.surface);
    const SurfaceTopology& topology = *cover.surface->topology;
    ElementId chosen = noElement;
    std::vector<Vec3> along;
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        if (chosen != noElement || seam.a.patch == seam.b.patch)
            return;
        chosen = id;
        const BSpline2& outline = design.find<Patch>(seam.a.patch)->outline;
        const double end = unwrappedEnd(seam.a.from, seam.a.to, outline.domainStart(), outline.domainEnd());
        const auto range = std::ranges::find(topology.patches, seam.a.patch, &SurfaceTopology::PatchRange::patch);
        const PatternLocator locator(topology, *range);
        for (int k = 0; k <= 12; ++k) {
            const PatternPlace place =
                locator.locate(outline.at(outline.wrapped(seam.a.from + (end - seam.a.from) * k / 12)));
            Vec3 at = Vec3::Zero();
            for (std::size_t c = 0; c < 3; ++c)
                at += place.weights[static_cast<Eigen::Index>(c)] * cover.surface->positions[place.corners[c]];
            along.push_back(at);
        }
    });
    ASSERT_NE(chosen, noElement);
    // A seam between top and side goes a little down the side.
    for (std::size_t k = 2; k + 2 < along.size(); ++k)
        along[k].z() -= 5;
    FitOrder order = orderFor(design);
    order.goals.seams = {{chosen, BSpline3(1, false, along)}};
    const FitResult result = fitPattern(design, order);
    ASSERT_EQ(result.status, FitResult::Status::Done) << result.reason.english();
    EXPECT_GT(result.before.seamRms, 3);
    EXPECT_LT(result.after.seamRms, 0.5 * result.before.seamRms);
    EXPECT_LT(result.after.shapeRms, 2) << "mm: the cover stays about where it is";
}

TEST(FitGoals, ClothThatIsPressedTogetherGetsSmooth)
{
    const Design right = coarseSample("box-cushion", coarseEdge);
    const ElementId patch = firstPatch(right);
    Patch wide = *right.find<Patch>(patch);
    std::vector<Vec2> points = wide.outline.points();
    const Vec2 middle = wide.outline.boundingBox().center();
    for (Vec2& point : points)
        point = middle + 1.05 * (point - middle);
    wide.outline = wide.outline.withPoints(points);
    const Design design = right.with({{}, {{patch, right.element(patch), makeElement(std::move(wide))}}});
    FitOrder order = orderFor(design);
    order.locks.lengths = false; // its seams are too long for their other sides
    order.goals.smooth = {patch};
    const FitResult result = fitPattern(design, order);
    ASSERT_EQ(result.status, FitResult::Status::Done) << result.reason.english();
    EXPECT_GT(result.before.pressed, 0.2);
    EXPECT_LT(result.after.pressed, 0.5 * result.before.pressed);
}

/// Far below what can be reached: less beyond the limit in all, which is what is reckoned with, may mean more over
/// it.
TEST(FitGoals, MoreThatIsOverTheLimitIsNoGain)
{
    const Design design = coarseSample("box-cushion", coarseEdge);
    FitOrder order = orderFor(design);
    order.goals.strain = true;
    order.goals.keepShape = FitGoals::lightly;
    for (const double limit : {1.0, 1.5, 2.0}) {
        order.goals.limit = limit; // percent
        const FitResult result = fitPattern(design, order);
        ASSERT_TRUE(result.reason.empty()) << result.reason.english();
        EXPECT_LE(result.after.overLimit, result.before.overLimit) << limit;
        EXPECT_TRUE(result.after.overLimit < result.before.overLimit ||
                    result.after.strainRms <= result.before.strainRms)
            << limit;
        EXPECT_EQ(result.status == FitResult::Status::NothingToDo, result.values.isZero());
    }
}

/// What lies outside of the area may be as far off as it likes.
TEST(FitGoals, WhatComesHardlyNearerIsSaidGoalByGoal)
{
    FitFigures before, after;
    before.distanceRms = 8;
    after.distanceRms = 7.6;
    before.overLimit = 0.2;
    after.overLimit = 0.19;
    before.pressed = 0.3;
    after.pressed = 0.1;
    const std::vector<MissedGoal> missed = missedGoals(true, before, after);
    ASSERT_EQ(missed.size(), 2U);
    EXPECT_EQ(missed[0].kind, MissedGoal::Kind::Form);
    EXPECT_EQ(missed[0].after, 7.6);
    EXPECT_EQ(missed[1].kind, MissedGoal::Kind::Strain);
    EXPECT_EQ(missedGoals(false, before, after).size(), 1U) << "a limit that is no goal is not missed";

    after.distanceRms = 0.4;
    before.distanceRms = 0.42;
    EXPECT_TRUE(missedGoals(false, before, after).empty()) << "it was reached from the beginning";
    before.sizeMost = after.sizeMost = 0.1;
    before.seamRms = 5;
    after.seamRms = 4;
    before.pressed = 0.9;
    after.pressed = 0.6;
    const std::vector<MissedGoal> half = missedGoals(false, before, after);
    ASSERT_EQ(half.size(), 2U);
    EXPECT_EQ(half[0].kind, MissedGoal::Kind::Smooth) << "most of it is still pressed together";
    EXPECT_EQ(half[1].kind, MissedGoal::Kind::Sizes);
}

TEST(FitGoals, OnlyAPaintedAreaCounts)
{
    FitArea area{{}, {{ElementId{7}, Vec2(100, 50), 20}}};
    EXPECT_TRUE(area.has(ElementId{7}, Vec2(110, 60)));
    EXPECT_FALSE(area.has(ElementId{7}, Vec2(125, 50)));
    EXPECT_FALSE(area.has(ElementId{8}, Vec2(100, 50)));
    EXPECT_FALSE(area.hasAny(ElementId{8}));
    area.patches.insert(ElementId{8});
    EXPECT_TRUE(area.has(ElementId{8}, Vec2(0, 0))) << "all of a patch, and a spot of another";
    EXPECT_TRUE(FitArea{}.has(ElementId{9}, Vec2(0, 0))) << "nothing said: everything";

    const Design design = coarseSample("box-cushion", coarseEdge);
    const ElementId patch = firstPatch(design);
    const auto overIn = [&](const FitArea& meant) {
        FitOrder order = orderFor(design);
        order.mostRounds = 2;
        order.goals.strain = true;
        order.goals.limit = 2.6; // percent: within reach
        order.goals.area = meant;
        return fitPattern(design, order);
    };
    const Vec2 middle = design.find<Patch>(patch)->outline.boundingBox().center();
    const FitResult everywhere = overIn({}), there = overIn({{}, {{patch, middle, 60}}});
    ASSERT_EQ(there.status, FitResult::Status::Done) << there.reason.english();
    EXPECT_NE(there.before.overLimit, everywhere.before.overLimit);
    EXPECT_LT(there.after.overLimit, there.before.overLimit);
}

TEST(FitGoals, TheDistanceIsThatOfTheArea)
{
    const Design design = coarseSample("box-cushion", coarseEdge);
    const ElementId patch = firstPatch(design);
    const AreaSpot spot{patch, design.find<Patch>(patch)->outline.boundingBox().center(), 60};
    const SolveResult cover = solved(design, 1e-6);
    ASSERT_TRUE(cover.surface);
    TriangleMesh form;
    form.points = cover.surface->positions;
    form.triangles = cover.surface->topology->triangles;
    for (const SurfaceTopology::PatchRange& range : cover.surface->topology->patches)
        for (std::uint32_t v = range.firstVertex; v < range.firstVertex + range.vertexCount; ++v)
            if (FitArea{{}, {spot}}.has(range.patch, cover.surface->topology->pattern[v]))
                form.points[v] += 4 * cover.surface->normals[v].cast<double>();
    FitOrder order = orderFor(design);
    order.goals.target = targetOf(form);
    const auto distanceIn = [&](const FitArea& area) {
        order.goals.area = area;
        const auto measured = measureChange(design, order, design);
        return measured ? measured->before : FitFigures();
    };
    const FitFigures whole = distanceIn({}), there = distanceIn({{}, {spot}});
    EXPECT_GT(there.distanceRms, 2);
    EXPECT_LT(whole.distanceRms, 0.6 * there.distanceRms);
    EXPECT_GT(there.covered, 0.9) << "of the area";
    EXPECT_EQ(there.overLimit, whole.overLimit) << "what fabrics do not allow counts everywhere";
}

/// A seam between edges of different lengths: with the ease as it is its sides come nearer to each other, with a
/// free one the ease becomes what they are.
TEST(FitGoals, EasesBecomeWhatSidesAre)
{
    const Design design = coarseSample("box-cushion", coarseEdge);
    const ElementId patch = firstPatch(design);
    FitOrder order = orderFor(design);
    order.goals.sizes = {{patch, 0.95}};
    const FitResult kept = fitPattern(design, order);
    order.locks.ease = false;
    const FitResult free = fitPattern(design, order);
    ASSERT_EQ(kept.status, FitResult::Status::Done) << kept.reason.english();
    ASSERT_EQ(free.status, FitResult::Status::Done) << free.reason.english();
    const auto differences = [&](const Design& of) {
        std::vector<double> all;
        of.each<Seam>([&](ElementId, const Seam& seam) {
            const auto length = [&](const Stretch& stretch) {
                const BSpline2& outline = of.find<Patch>(stretch.patch)->outline;
                return ArcLength2(outline).between(
                    stretch.from,
                    unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd()));
            };
            all.push_back(length(seam.b) - length(seam.a));
        });
        return all;
    };
    const std::vector<double> before = differences(design), after = differences(free.design);
    std::size_t k = 0;
    double most = 0;
    free.design.each<Seam>([&](ElementId id, const Seam& seam) {
        const double more = after[k] - before[k];
        EXPECT_NEAR(seam.ease, design.find<Seam>(id)->ease + more, 0.06) << number(id);
        most = std::max(most, std::abs(more));
        ++k;
    });
    EXPECT_GT(most, 1) << "mm: the patch alone became smaller";
    kept.design.each<Seam>(
        [&](ElementId id, const Seam& seam) { EXPECT_EQ(seam.ease, design.find<Seam>(id)->ease); });
}

/// The cover of a fabric that contracts more is fitted by the fabric's own numbers, which stay within their limits.
TEST(FitGoals, AFabricsStretchIsFound)
{
    const Design design = coarseSample("cylinder", coarseEdge);
    const std::vector<Freedom> freedoms = stretchFreedoms(design);
    ASSERT_EQ(freedoms.size(), 2u) << "stiffness and Poisson number of its fabric";
    EXPECT_NEAR(freedoms[1].most + design.find<Fabric>(freedoms[1].element)->poisson, 0.5, 1e-12);
    EXPECT_NEAR(freedoms[1].least + design.find<Fabric>(freedoms[1].element)->poisson, -0.5, 1e-12);
    const Design other = changedBy(design, freedoms[1], -0.4);
    const SolveResult cover = solved(other, 1e-6);
    ASSERT_TRUE(cover.surface);
    PointCloud cloud;
    for (const Vec3& place : cover.surface->positions)
        cloud.points.push_back(place);
    FitOrder order;
    order.goals.target = targetOf(Scan{}, cloud);
    order.freedoms = {freedoms[1]};
    order.mostChange = 100;
    const FitResult result = fitPattern(design, order);
    ASSERT_EQ(result.status, FitResult::Status::Done) << result.reason.english();
    EXPECT_LT(result.after.distanceRms, result.before.distanceRms);
    EXPECT_GE(result.values[0], freedoms[1].least);
    EXPECT_LE(result.values[0], freedoms[1].most);
}

TEST(FitGoals, AnElementThatIsGoneIsNoGoal)
{
    const Design design = coarseSample("box-cushion", coarseEdge);
    FitOrder order = orderFor(design);
    order.mostRounds = 1;
    order.goals.sizes = {{static_cast<ElementId>(99999), 0.5}};
    order.goals.seams = {{static_cast<ElementId>(99999), BSpline3(1, false, {Vec3::Zero(), Vec3::UnitX()})}};
    const FitResult result = fitPattern(design, order);
    EXPECT_NE(result.status, FitResult::Status::Failed) << result.reason.english();
    EXPECT_EQ(result.after.sizeMost, 0);
    EXPECT_EQ(result.after.seamRms, 0);
}

} // namespace
} // namespace bolster::test
