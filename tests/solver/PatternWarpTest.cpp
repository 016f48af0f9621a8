#include "TestDesigns.h"

#include "PatchEdits.h"
#include "PatternWarp.h"
#include "PreparedSheet.h"
#include "Relaxation.h"

#include <gtest/gtest.h>

#include <numbers>

namespace bolster::test {
namespace {

/// A sheet with a handle in it, held by a curve at its left edge, or by nothing.
struct Sheet {
    Design design;
    ElementId patch{};
    ElementId handle{};

    explicit Sheet(double edgeLength = 12)
    {
        DesignBuilder b(edgeLength);
        patch = b.patch(rectangle(300, 200), b.fabric(0.3, 8));
        b.fix({patch, 3, 4}, polyline({{0, 200, 0}, {0, 0, 0}}));
        HandleCurve drawn;
        drawn.name = "Handle";
        drawn.patch = patch;
        drawn.curve = BSpline2(1, false, {{150, 60}, {150, 140}});
        drawn.target = BSpline3(1, false, {{140, 60, 30}, {140, 140, 30}});
        handle = b.add(std::move(drawn));
        design = b.design();
    }

    Design with(const std::function<Vec2(Vec2)>& move) const
    {
        Patch moved = *design.find<Patch>(patch);
        std::vector<Vec2> points = moved.outline.points();
        std::ranges::transform(points, points.begin(), move);
        moved.outline = BSpline2(1, true, std::move(points));
        return design.with({{}, {{patch, design.element(patch), makeElement(std::move(moved))}}});
    }
};

Vec2 longer(const Vec2& p)
{
    return {1.1 * p.x(), p.y()};
}

/// The mesh of one design, bent to another.
SewnMesh bent(PreparedSheet sheet, const Design& design)
{
    EXPECT_TRUE(resample(sheet.sampling, design));
    WorkerPool pool(2);
    PatternWarp warp(sheet.mesh);
    std::optional<std::vector<Vec2>> pattern = warp.warped(sheet.mesh, sheet.sampling, pool);
    EXPECT_TRUE(pattern);
    if (pattern)
        reshape(sheet.mesh, std::move(*pattern), pool);
    updateTargets(sheet.mesh, sheet.sampling);
    return sheet.mesh;
}

PreparedSheet prepared(const Design& design)
{
    TriangulationCache cache;
    return *prepareSheet(design, cache);
}

TEST(Distortion, IsWhatQuadraticFormsGrowBy)
{
    const std::vector<std::array<std::uint32_t, 3>> triangle{{0, 1, 2}};
    const std::vector<Vec2> before{{0, 0}, {10, 0}, {3, 8}};
    const auto mapped = [&](const Eigen::Matrix2d& map) {
        std::vector<Vec2> after;
        for (const Vec2& p : before)
            after.push_back(map * p + Vec2(5, -7));
        WorkerPool pool(1);
        return distortion(triangle, before, after, pool);
    };
    EXPECT_NEAR(mapped(Eigen::Rotation2Dd(0.7).toRotationMatrix()), 1, 1e-7);
    EXPECT_NEAR(mapped(Eigen::DiagonalMatrix<double, 2>(1.2, 1)), 1.2, 1e-9);
    EXPECT_NEAR(mapped(Eigen::DiagonalMatrix<double, 2>(1.1, 1.1)), 1.21, 1e-9);
    EXPECT_NEAR(mapped(Eigen::DiagonalMatrix<double, 2>(0.5, 1)), 2, 1e-9);
    EXPECT_FALSE(mapped(Eigen::DiagonalMatrix<double, 2>(-1, 1)) < 1e300);
}

TEST(PatternWarp, FollowsTheOutlineAndKeepsHandlesWhereTheyAre)
{
    const Sheet sheet;
    const PreparedSheet before = prepared(sheet.design);
    const SewnMesh mesh = bent(before, sheet.with(longer));
    for (int k = 0; k < mesh.parts[0].boundaryCount; ++k)
        EXPECT_LT((mesh.rest()[k] - longer(before.mesh.rest()[k])).norm(), 1e-9);
    for (const std::uint32_t vertex : mesh.topology->lines[0].vertices)
        EXPECT_LT((mesh.rest()[vertex] - before.mesh.rest()[vertex]).norm(), 1e-9);
    double area = 0;
    for (const double a : mesh.area)
        area += a;
    EXPECT_NEAR(area, 330 * 200, 1e-6);
    EXPECT_EQ(mesh.topology->serial, before.mesh.topology->serial);
    EXPECT_EQ(before.mesh.rest()[1].y(), before.mesh.rest()[0].y()) << "what was published has changed";
}

TEST(PatternWarp, IsExactForLinearMaps)
{
    DesignBuilder b(12);
    const ElementId patch = b.patch(rectangle(300, 200), b.fabric(0.3, 8));
    const PreparedSheet before = prepared(b.design());
    Patch sheared = *b.design().find<Patch>(patch);
    sheared.outline = BSpline2(1, true, {{0, 0}, {310, 10}, {330, 205}, {20, 195}});
    const Design after =
        b.design().with({{}, {{patch, b.design().element(patch), makeElement(std::move(sheared))}}});
    const SewnMesh mesh = bent(before, after);
    Eigen::Matrix2d map;
    map << 310.0 / 300, 20.0 / 200, 10.0 / 300, 195.0 / 200;
    for (std::size_t v = 0; v < mesh.rest().size(); ++v)
        EXPECT_LT((mesh.rest()[v] - map * before.mesh.rest()[v]).norm(), 1e-6) << v;
}

TEST(PatternWarp, RefusesToFoldThePattern)
{
    const Sheet sheet;
    PreparedSheet before = prepared(sheet.design);
    // The right edge beyond the handle, which stays where it is.
    ASSERT_FALSE(resample(before.sampling, sheet.with([](const Vec2& p) { return Vec2(0.4 * p.x(), p.y()); })));
    PreparedSheet narrow = prepared(sheet.design);
    ASSERT_TRUE(resample(narrow.sampling, sheet.with([](const Vec2& p) { return Vec2(0.56 * p.x(), p.y()); })));
    WorkerPool pool(1);
    EXPECT_FALSE(PatternWarp(narrow.mesh).warped(narrow.mesh, narrow.sampling, pool));
}

/// Old matrices with new forces end where new matrices do, and every distortion that they are kept for converges.
TEST(PatternWarp, OldFactorsLeadToTheSameSurface)
{
    Sheet sheet;
    sheet.design = sheet.design.with({{}, {{sheet.handle, sheet.design.element(sheet.handle), nullptr}}});
    for (const double share : {0.04, 0.1, 0.15, 0.18, 0.35}) {
        const auto move = [share](const Vec2& p) { return Vec2((1 + share) * p.x(), p.y()); };
        const PreparedSheet before = prepared(sheet.design);
        const SewnMesh after = bent(before, sheet.with(move));
        WorkerPool pool(1);
        const auto converge = [](Relaxation& relaxation) {
            while (relaxation.phase() == Relaxation::Phase::Running && relaxation.iterations() < 3000)
                relaxation.iterate();
            EXPECT_EQ(relaxation.phase(), Relaxation::Phase::Converged);
        };
        constexpr double tolerance = 1e-7;
        SewnMesh mesh = before.mesh;
        Relaxation dragged(mesh, pool, tolerance);
        dragged.startCanonically();
        converge(dragged);
        mesh = after;
        dragged.reshape();
        converge(dragged);
        Relaxation fresh(after, pool, tolerance);
        fresh.startFrom(dragged.state(), false);
        converge(fresh);
        EXPECT_LT((fresh.state().positions - dragged.state().positions).cwiseAbs().maxCoeff(), 1e-3) << share;
    }
}

TEST(Resample, KeepsSewnSamplesTogether)
{
    DesignBuilder b(15);
    const ElementId fabric = b.fabric(0.3, 8);
    const ElementId left = b.patch(rectangle(200, 150), fabric), right = b.patch(rectangle(100, 150), fabric);
    b.seam({left, 1, 2}, {right, 3, 4});
    PreparedSheet sheet = prepared(b.design());
    const int points[] = {1, 2};
    const Design moved = b.design().with(edits::movePatchPoints(b.design(), left, points, Vec2(20, 5)));
    const OutlineSampling before = sheet.sampling;
    ASSERT_TRUE(resample(sheet.sampling, moved));
    EXPECT_EQ(sheet.sampling.outlines[0].points.size(), before.outlines[0].points.size());
    EXPECT_EQ(sheet.sampling.seams[0].a, before.seams[0].a);
    EXPECT_EQ(sheet.sampling.outlines[1].points, before.outlines[1].points);
    for (const int sample : sheet.sampling.seams[0].a)
        EXPECT_NEAR(sheet.sampling.outlines[0].points[sample].x(), 220, 1e-9);
}

TEST(Resample, RefusesHandlesThatNeedMorePoints)
{
    const Sheet sheet;
    PreparedSheet before = prepared(sheet.design);
    HandleCurve longer = *sheet.design.find<HandleCurve>(sheet.handle);
    longer.curve = BSpline2(1, false, {{150, 20}, {150, 180}});
    const Design design = sheet.design.with(
        {{}, {{sheet.handle, sheet.design.element(sheet.handle), makeElement(std::move(longer))}}});
    EXPECT_FALSE(resample(before.sampling, design));
}

} // namespace
} // namespace bolster::test
