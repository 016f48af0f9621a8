#include "DesignCheck.h"
#include "PlaneCurves.h"
#include "TestDesigns.h"
#include "TriangleStrain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bolster::test {
namespace {

class Samples : public testing::TestWithParam<const char*> {};

TEST_P(Samples, AreSewnFixedAndUnflipped)
{
    const SolveResult result = solved(sample(GetParam()), 1e-6);
    ASSERT_TRUE(result.surface);
    EXPECT_EQ(result.report.seamGap.max, 0);
    EXPECT_LT(result.report.fixationError.max, 1e-6);
    EXPECT_EQ(result.report.flippedTriangles, 0);
    EXPECT_TRUE(result.leftOut.empty());
    for (std::size_t v = 0; v < result.surface->positions.size(); ++v) {
        ASSERT_TRUE(result.surface->positions[v].allFinite());
        ASSERT_NEAR(result.surface->normals[v].norm(), 1, 1e-5);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Samples,
                         testing::Values("trapezoid", "cylinder", "box-cushion", "pillow", "armchair", "car-seat",
                                         "car-seat-cushioned", "trapezoid-cushion"),
                         [](const auto& chosen) {
                             std::string name = chosen.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

class PoissonRange : public testing::TestWithParam<double> {};

TEST_P(PoissonRange, AFreeFlapComesToRest)
{
    DesignBuilder b(24);
    const ElementId fabric = b.fabric(GetParam(), 12);
    const ElementId seat = b.patch(rectangle(500, 480), fabric), flap = b.patch(rectangle(120, 480), fabric);
    b.fix({seat, 0, 1}, BSpline3(3, false, {{0, 0, 0}, {150, 0, 20}, {300, 0, 20}, {500, 0, 0}}));
    b.seam({seat, 1, 2}, {flap, 3, 4});
    const SolveResult result = solved(b.design(), 1e-6);
    EXPECT_EQ(result.status, SolveResult::Status::Solved);
    EXPECT_LT(result.report.strain.max, 0.01);
}

TEST_P(PoissonRange, ATubeHasNoKnots)
{
    Design design = tube(600, 400, 16, 10);
    Edit edit;
    design.each<Fabric>([&](ElementId id, const Fabric& fabric) {
        Fabric other = fabric;
        other.poisson = GetParam();
        edit.changes.push_back({id, design.element(id), makeElement(other)});
    });
    const SolveResult result = solved(design.with(edit), 1e-6);
    EXPECT_EQ(result.status, SolveResult::Status::Solved);
    EXPECT_LT(result.report.strain.max, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Ends, PoissonRange, testing::Values(-0.5, 0.4, 0.5), [](const auto& chosen) {
    return std::string(chosen.param < 0 ? "Minus" : "") + std::to_string(std::lround(100 * std::abs(chosen.param)));
});

TEST(RestingSolve, IsTheSameBitForBit)
{
    const Design design = sample("trapezoid"); // folds amplify any difference
    SolveOptions options;
    options.maxIterations = 150;
    std::vector<SurfaceMeshPtr> surfaces;
    for (int threads : {1, 2, 3, 2}) {
        options.threads = threads;
        surfaces.push_back(solveResting(design, options).surface);
        ASSERT_TRUE(surfaces.back());
        EXPECT_EQ(surfaces.back()->positions, surfaces.front()->positions);
        EXPECT_EQ(surfaces.back()->topology->triangles, surfaces.front()->topology->triangles);
    }
}

TEST(RestingSolve, LayoutAndFrameChangeNothing)
{
    const Design design = box(200, 60, 15, 10, 0.3);
    SolveOptions options;
    const SurfaceMeshPtr before = solveResting(design, options).surface;
    Edit edit;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        Patch moved = patch;
        moved.position = Vec2(100.0 * number(id), -33);
        moved.rotation = 17.0 * number(id);
        edit.changes.push_back({id, design.element(id), makeElement(moved)});
    });
    EXPECT_EQ(solveResting(design.with(edit), options).surface->positions, before->positions);
}

TEST(RestingSolve, FreeCoverStaysWhereItIs)
{
    DesignBuilder b(15);
    const ElementId fabric = b.fabric(0.3, 8);
    const ElementId front = b.patch(rectangle(300, 200), fabric, 0.3),
                    back = b.patch(rectangle(300, 200), fabric, 0.3);
    b.seam({front, 0, 0}, {back, 2, 2});
    const SolveResult result = solved(b.design(), 1e-6);
    EXPECT_TRUE(result.warnings.empty()) << "what is filled lies free";
    Vec3 centre = Vec3::Zero();
    for (const Vec3& p : result.surface->positions)
        centre += p / static_cast<double>(result.surface->positions.size());
    EXPECT_LT(centre.norm(), 20);
    EXPECT_GT(result.surface->boundingBox().sizes().z(), 30) << "inflated";
    EXPECT_EQ(result.report.flippedTriangles, 0);
}

TEST(RestingSolve, WrongSideOutTurnsTheCoverInsideOut)
{
    Design design = box(200, 60, 15, 10, 0.5);
    const double outside = solved(design, 1e-6).surface->boundingBox().max().z();
    Edit edit;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        Patch turned = patch;
        turned.wrongSideOut = true;
        edit.changes.push_back({id, design.element(id), makeElement(turned)});
    });
    const SolveResult result = solved(design.with(edit), 1e-6);
    EXPECT_LT(result.surface->boundingBox().min().z(), -50) << "the sides hang down now";
    EXPECT_NEAR(result.surface->boundingBox().min().z(), -outside, 0.05 * outside);
    EXPECT_EQ(result.report.flippedTriangles, 0);
}

TEST(RestingSolve, StrictFailsLenientLeavesOut)
{
    DesignBuilder b(15);
    const ElementId fabric = b.fabric(0.3, 8);
    const ElementId good = b.patch(rectangle(200, 100), fabric);
    b.fix({good, 0, 1}, polyline({{0, 0, 0}, {200, 0, 0}}));
    const ElementId crossed = b.patch({{0, 0}, {100, 0}, {0, 100}, {100, 100}}, fabric);
    const ElementId seam = b.seam({good, 2, 3}, {crossed, 0, 1});
    SolveOptions options;
    const SolveResult strict = solveResting(b.design(), options);
    EXPECT_EQ(strict.status, SolveResult::Status::Failed);
    EXPECT_FALSE(strict.surface);
    EXPECT_FALSE(strict.reason.empty());
    ASSERT_FALSE(strict.errors.empty());
    EXPECT_EQ(strict.errors[0].element, crossed);

    options.lenient = true;
    const SolveResult lenient = solveResting(b.design(), options);
    EXPECT_EQ(lenient.status, SolveResult::Status::Solved);
    EXPECT_EQ(lenient.report.patches, 1);
    ASSERT_EQ(lenient.leftOut.size(), 2u);
    EXPECT_EQ(lenient.leftOut[0].element, crossed);
    EXPECT_EQ(lenient.leftOut[1].element, seam);
}

TEST(RestingSolve, ConflictingFixationsAreRefusedOrLeftOut)
{
    DesignBuilder b(15);
    const ElementId patch = b.patch(rectangle(200, 100), b.fabric(0.3, 8));
    b.fix({patch, 0, 1}, polyline({{0, 0, 0}, {200, 0, 0}}));
    const ElementId second = b.fix({patch, 1, 2}, polyline({{200, 0, 40}, {200, 100, 40}}));
    EXPECT_EQ(solveResting(b.design(), {}).status, SolveResult::Status::Failed);
    EXPECT_TRUE(hasErrors(checkSolvable(b.design())));
    SolveOptions lenient;
    lenient.lenient = true;
    const SolveResult result = solveResting(b.design(), lenient);
    EXPECT_EQ(result.status, SolveResult::Status::Solved);
    ASSERT_EQ(result.leftOut.size(), 1u);
    EXPECT_EQ(result.leftOut[0].element, second);
}

/// A crescent 1.5 mm wide, whose sides cross when they are sampled.
TEST(RestingSolve, PatchesTooNarrowForTheirEdgesAreFoundBefore)
{
    DesignBuilder b(80);
    b.patch(edits::joined({BSpline2(2, false, {{-100, 0}, {0, 97}, {100, 0}}),
                           BSpline2(2, false, {{100, 0}, {55, 45}, {10, 49.5}}),
                           BSpline2(2, false, {{10, 49.5}, {-45, 55}, {-100, 0}})},
                          nullptr),
            b.fabric(0.3, 8));
    EXPECT_FALSE(hasErrors(checkDesign(b.design())));
    EXPECT_EQ(solveResting(b.design(), {}).status, SolveResult::Status::Failed);
    EXPECT_TRUE(hasErrors(checkSolvable(b.design())));
}

TEST(RestingSolve, SolvesWhatIsHeldAtEveryVertex)
{
    DesignBuilder b(12);
    const ElementId strip = b.patch(rectangle(500, 8), b.fabric(0.3, 6));
    b.fix({strip, 0, 0}, polyline({{0, 0, 0}, {500, 0, 0}, {500, 8, 0}, {0, 8, 0}}, true));
    const SolveResult result = solved(b.design());
    EXPECT_EQ(result.report.constraints.fixed, result.report.vertices);
    EXPECT_LT(result.report.strain.max, 1e-9);
}

TEST(RestingSolve, ACornerSewnToItselfKeepsItsTriangles)
{
    DesignBuilder b(12);
    const ElementId patch = b.patch(rectangle(300, 300), b.fabric(0.3, 6));
    b.seam({patch, 1, 2}, {patch, 2, 3});
    const SolveResult result = solved(b.design(), 1e-6);
    EXPECT_LT(result.report.strain.max, 0.9);
    const SurfaceTopology& topology = *result.surface->topology;
    for (const auto& [p, q, r] : topology.triangles)
        EXPECT_TRUE(topology.unknown[p] != topology.unknown[q] && topology.unknown[q] != topology.unknown[r] &&
                    topology.unknown[r] != topology.unknown[p]);
}

TEST(RestingSolve, SaysWhenItHasNotConverged)
{
    SolveOptions options;
    options.maxIterations = 5;
    const SolveResult result = solveResting(box(200, 60, 15, 10, 0.5), options);
    EXPECT_EQ(result.status, SolveResult::Status::NotConverged);
    EXPECT_EQ(result.report.iterations, 5);
    EXPECT_TRUE(result.surface);
    EXPECT_FALSE(result.reason.empty());
}

TEST(RestingSolve, CanBeCancelled)
{
    std::stop_source source;
    const SolveResult result =
        solveResting(box(200, 60, 10, 10, 0.5), {}, source.get_token(), [&](int iteration, double) {
            if (iteration == 3)
                source.request_stop();
        });
    EXPECT_EQ(result.status, SolveResult::Status::Cancelled);
}

TEST(RestingSolve, NothingToSolveIsSaid)
{
    const SolveResult result = solveResting(Design(), {});
    EXPECT_EQ(result.status, SolveResult::Status::Failed);
    EXPECT_FALSE(result.reason.empty());
}

TEST(RestingSolve, SurvivesABendingLengthThatTheMeshCannotResolve)
{
    for (double bending : {0.0, 1.0, 500.0}) {
        DesignBuilder b(15);
        const ElementId patch = b.patch(rectangle(200, 100), b.fabric(0.3, bending));
        b.fix({patch, 0, 1}, polyline({{0, 0, 0}, {190, 0, 0}}));
        EXPECT_TRUE(solved(b.design(), 1e-6).surface) << bending;
    }
}

TEST(RestingSolve, DartsAndTubesOfOnePatchCanBeSewn)
{
    DesignBuilder b(8);
    const ElementId patch =
        b.patch({{0, 0}, {90, 0}, {100, 80}, {110, 0}, {200, 0}, {200, 120}, {0, 120}}, b.fabric(0.3, 5));
    b.seam({patch, 1, 2}, {patch, 2, 3}); // a dart
    b.fix({patch, 5, 6}, polyline({{200, 120, 0}, {0, 120, 0}}));
    const SolveResult result = solved(b.design(), 1e-6);
    EXPECT_EQ(result.report.seamGap.max, 0);
}

TEST(SurfaceMeasures, PrincipalStretches)
{
    const std::array<Vec2, 3> rest{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
    const Eigen::Vector2d stretches = principalStretches(rest, {Vec3(0, 0, 0), Vec3(0, 0, 1.2), Vec3(0.9, 0, 0)});
    EXPECT_NEAR(stretches[0], 1.2, 1e-12);
    EXPECT_NEAR(stretches[1], 0.9, 1e-12);
}

} // namespace
} // namespace bolster::test
