// Large designs are dragged on fewer triangles; neither when they come nor when they go is it seen.
#include "Listener.h"
#include "TestDesigns.h"
#include "TestMeshes.h"

#include "CoverMove.h"
#include "CurveEdits.h"
#include "PatchEdits.h"
#include "PreparedSheet.h"
#include "Relaxation.h"
#include "RestingSolve.h"
#include "StateTransfer.h"

#include <gtest/gtest.h>

#include <numbers>

namespace bolster::test {
namespace {

using State = SolverStatus::State;

/// Some 50,000 vertices.
Design large(const char* name, double edge)
{
    return withEdgeLength({sample(name), {}}, edge).design;
}

std::size_t vertices(const SolverOutput& output)
{
    return output.surface->positions.size();
}

std::optional<SolverOutput> follow(Listener& solver, const Design& design, std::uint64_t revision)
{
    solver.request(design, revision, true);
    return solver.waitFor([&](const SolverOutput& o) { return o.designRevision == revision && o.surface; });
}

std::optional<SolverOutput> rest(Listener& solver, const Design& design, std::uint64_t revision)
{
    solver.request(design, revision);
    return solver.waitFor([&](const SolverOutput& o) { return o.designRevision == revision && o.status.resting; });
}

PreparedSheet prepareOn(const Design& design)
{
    TriangulationCache cache;
    return *prepareSheet({design, {}}, cache);
}

class StandIn : public testing::TestWithParam<std::pair<const char*, double>> {
protected:
    Design design = large(GetParam().first, GetParam().second);
    Listener solver;
    std::optional<SolverOutput> before = (solver.setStepBudget(0), rest(solver, design, 1));
};

TEST_P(StandIn, BeginsWhereTheCoverRests)
{
    ASSERT_TRUE(before);
    const auto live = follow(solver, withCurveMoved(design, Vec3(0, 0, 0.001)), 2);
    ASSERT_TRUE(live);
    EXPECT_LT(vertices(*live), 0.5 * vertices(*before));
    EXPECT_LT(moveBetween(*before->surface, *live->surface).distance, 0.5);
    // And stays there, though triangles of this size alone would lead elsewhere.
    solver.request(withCurveMoved(design, Vec3(0, 0, 0.001)), 3, true);
    const auto settled = solver.waitFor([](const SolverOutput& o) {
        return o.designRevision == 3 && o.status.state == State::Settled && !o.status.resting;
    });
    ASSERT_TRUE(settled);
    EXPECT_LT(moveBetween(*before->surface, *settled->surface).distance, 0.5);
}

TEST_P(StandIn, GivesWayToAllTrianglesWhenThePointerRests)
{
    ASSERT_TRUE(before);
    const Design moved = withCurveMoved(design, Vec3(0, 2, 3));
    solver.request(moved, 2, true);
    std::optional<SolverOutput> settled;
    const auto fine = solver.waitFor([&](const SolverOutput& o) {
        if (o.designRevision == 2 && o.status.state == State::Settled && !o.status.resting)
            settled = o;
        return o.designRevision == 2 && o.status.resting;
    });
    ASSERT_TRUE(fine && settled);
    EXPECT_LT(vertices(*settled), 0.5 * vertices(*fine));
    EXPECT_LT(moveBetween(*settled->surface, *fine->surface).distance, 0.5);
    // The next step has fewer again, and the answer after the gesture is the one of the design alone.
    const auto next = follow(solver, withCurveMoved(design, Vec3(0, 2, 3.01)), 3);
    ASSERT_TRUE(next);
    EXPECT_LT(vertices(*next), 0.5 * vertices(*fine));
    EXPECT_LT(moveBetween(*fine->surface, *next->surface).distance, 0.5);
    const auto after = rest(solver, moved, 4);
    ASSERT_TRUE(after);
    EXPECT_EQ(after->surface->positions, solveResting(moved, {}).surface->positions);
}

TEST_P(StandIn, FollowsOutlines)
{
    ASSERT_TRUE(before);
    const int points[] = {0};
    const Design moved = design.with(edits::movePatchPoints(design, firstOf<Patch>(design), points, Vec2(-2, -1)));
    const auto live = follow(solver, moved, 2);
    ASSERT_TRUE(live);
    EXPECT_LT(vertices(*live), 0.5 * vertices(*before));
    solver.request(moved, 3);
    const auto first = solver.waitFor([](const SolverOutput& o) { return o.designRevision == 3; });
    ASSERT_TRUE(first);
    EXPECT_FALSE(first->status.resting) << "where the gesture has led,";
    EXPECT_NE(first->surface->topology->serial, live->surface->topology->serial) << "on new triangles";
    EXPECT_GT(vertices(*first), vertices(*live));
    const auto after = solver.waitFor([](const SolverOutput& o) { return o.status.resting; });
    ASSERT_TRUE(after);
    EXPECT_EQ(after->surface->topology, first->surface->topology);
}

/// The pointer is quicker than the solver: what is released is seldom the last step that it has taken.
TEST_P(StandIn, IsLeftAtOnceThoughTheLastStepWasNotTaken)
{
    ASSERT_TRUE(before);
    const int points[] = {0};
    const auto moved = [&](double x) {
        return design.with(edits::movePatchPoints(design, firstOf<Patch>(design), points, Vec2(x, -1)));
    };
    ASSERT_TRUE(follow(solver, moved(-1), 2));
    solver.request(moved(-2), 3);
    const auto first = solver.waitFor([](const SolverOutput& o) { return o.designRevision == 3; });
    ASSERT_TRUE(first);
    EXPECT_FALSE(first->status.resting);
    EXPECT_EQ(first->surface->topology->vertexCount(), prepareOn(moved(-2)).mesh.topology->vertexCount());
}

/// A gesture that begins before there is any surface.
TEST_P(StandIn, ComesFirst)
{
    Listener other;
    other.setStepBudget(0);
    const auto live = follow(other, design, 1);
    ASSERT_TRUE(live && before);
    EXPECT_LT(vertices(*live), 0.5 * vertices(*before));
}

TEST_P(StandIn, IsNotSeenAfterEscape)
{
    ASSERT_TRUE(before);
    ASSERT_TRUE(follow(solver, withCurveMoved(design, Vec3(0, 0, 30)), 2));
    const auto after = rest(solver, design, 3);
    ASSERT_TRUE(after);
    EXPECT_EQ(after->surface->positions, before->surface->positions);
}

INSTANTIATE_TEST_SUITE_P(Samples, StandIn,
                         testing::Values(std::pair("car-seat", 4.8), std::pair("box-cushion", 3.3)),
                         [](const auto& one) {
                             std::string name = one.param.first;
                             std::erase(name, '-');
                             return name;
                         });

/// Positions and frames of a sheet that is rolled about the z axis.
SheetState rolled(const SewnMesh& mesh, double radius)
{
    SheetState state{Eigen::Matrix3Xd(3, mesh.unknownCount()), Eigen::Matrix4Xd(4, mesh.vertexCount())};
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const double angle = mesh.rest()[v].x() / radius;
        const Vec3 normal(std::cos(angle), std::sin(angle), 0);
        Eigen::Matrix3d frame;
        frame << Vec3(-normal.y(), normal.x(), 0), Vec3::UnitZ(), normal;
        const Eigen::Quaterniond q(frame);
        state.frames.col(v) << q.w(), q.x(), q.y(), q.z();
        state.positions.col(mesh.topology->unknown[v]) = radius * normal + mesh.rest()[v].y() * Vec3::UnitZ();
    }
    return state;
}

TEST(StateTransfer, FinerTrianglesAreAsRoundAsTheCover)
{
    constexpr double radius = 100;
    const auto withEdge = [&](double edge) {
        TriangulationCache cache;
        return *prepareSheet(tube(2 * std::numbers::pi * radius, 200, edge, 5), cache);
    };
    const PreparedSheet coarse = withEdge(16), fine = withEdge(4);
    const SheetState state = transferState(coarse.mesh, rolled(coarse.mesh, radius), fine.mesh);
    const Eigen::ArrayXd radii = state.positions.topRows<2>().colwise().norm();
    const double sagOfFacets = 16 * 16 / (8 * radius);
    EXPECT_LT((radii - radius).abs().maxCoeff(), 0.05 * sagOfFacets);
}

} // namespace
} // namespace bolster::test
