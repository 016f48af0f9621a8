#include "TestDesigns.h"

#include "CoverMap.h"
#include "ScanAlign.h"
#include "ScanGhosts.h"
#include "ScanMeasure.h"
#include "SolvePlan.h"

#include <gtest/gtest.h>

#include <random>

namespace bolster::test {
namespace {

/// Where the points of a scan lie above (x, y).
using Height = std::function<double(double x, double y)>;

PointCloud scanOf(const Height& height, double size, double spacing)
{
    PointCloud cloud;
    for (double x = 0; x <= size; x += spacing)
        for (double y = 0; y <= size; y += spacing)
            cloud.points.emplace_back(x, y, height(x, y));
    return cloud;
}

/// A square held along two opposite sides, at height 0.
Design heldSquare(double size, double edgeLength, double bendingLength = 6)
{
    DesignBuilder b(edgeLength);
    const ElementId patch = b.patch(rectangle(size, size), b.fabric(0.3, bendingLength));
    b.fix({patch, 0, 1}, polyline({{0, 0, 0}, {size, 0, 0}}));
    b.fix({patch, 2, 3}, polyline({{size, size, 0}, {0, size, 0}}));
    return b.design();
}

SolveInput withScan(const Design& design, Scan scan, PointCloud cloud)
{
    const ElementId id = design.nextId();
    scan.file = "scan.ply";
    SolveInput input = design.with({{}, {{id, nullptr, makeElement(std::move(scan))}}});
    input.files.clouds[id] = std::make_shared<const PointCloud>(std::move(cloud));
    return input;
}

SolveResult fitted(const SolveInput& input, int threads = 0)
{
    SolveOptions options;
    options.threads = threads;
    SolveResult result = solveResting(input, options);
    EXPECT_EQ(result.status, SolveResult::Status::Solved) << result.reason.english();
    return result;
}

double heightAt(const SurfaceMesh& surface, double x, double y)
{
    double nearest = 1e9, height = 0;
    for (const Vec3& p : surface.positions)
        if (const double d = std::hypot(p.x() - x, p.y() - y); d < nearest) {
            nearest = d;
            height = p.z();
        }
    return height;
}

double bump(double x, double y)
{
    return 12 * std::sin(x * std::numbers::pi / 300) * std::sin(y * std::numbers::pi / 300);
}

TEST(ScanIndex, FindsWhatALookAtEveryPointFinds)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> in(-100, 100);
    const auto any = [&] { return Vec3(in(random), in(random), in(random)); };
    PointCloud cloud;
    for (int i = 0; i < 3000; ++i)
        cloud.points.push_back(any() + Vec3(5000, 0, 0));
    const ScanIndex index(cloud, {});
    ScanMatch match;
    Vec3 at = Vec3(5000, 0, 0);
    for (int i = 0; i < 2000; ++i) {
        at = i % 100 == 0 ? Vec3(any() + Vec3(5000, 0, 0)) : Vec3(at + 0.02 * any());
        const double radius = i % 7 == 0 ? 5 : 30;
        int nearest = -1;
        for (int k = 0; k < index.size(); ++k)
            if (const double d = (index.point(k) - at).norm();
                d < radius && (nearest < 0 || d < (index.point(nearest) - at).norm()))
                nearest = k;
        const int found = index.search(at, radius).first;
        ASSERT_EQ(found, nearest);
        const int followed = match.follow(index, at, 30);
        ASSERT_EQ(followed, index.search(at, 33).first);
    }
}

TEST(ScanIndex, KnowsItsSpacingAndLeavesOutWhatIsCutAway)
{
    const PointCloud cloud = scanOf([](double, double) { return 0.0; }, 300, 3);
    EXPECT_NEAR(ScanIndex(cloud, {}).spacing(), 3, 0.6);
    const ScanCut half{{{Vec3::UnitX(), 150}}, false};
    EXPECT_EQ(ScanIndex(cloud, {half}).size(), 50 * 101);
    EXPECT_TRUE(ScanIndex(cloud, {half, {half.halfSpaces, true}}).empty());
    EXPECT_EQ(ScanIndex(PointCloud{{Vec3::Zero()}}, {}).search(Vec3(0, 0, 1), 2).first, 0)
        << "one point is a scan, too";
}

TEST(Scan, ACoverTakesTheShapeOfItsScanWhereverThatIsPlaced)
{
    Scan scan;
    scan.scale = 1000;
    scan.position = {10, 20, -30};
    scan.rotation = Quat(Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()));
    PointCloud cloud = scanOf(bump, 300, 3);
    for (Vec3& point : cloud.points)
        point = scan.filePoint(point);
    const SolveResult result = fitted(withScan(heldSquare(300, 8), scan, std::move(cloud)));
    EXPECT_NEAR(heightAt(*result.surface, 150, 150), 12, 0.3);
    ASSERT_EQ(result.report.scans.size(), 1u);
    const ScanFigures& fit = result.report.scans[0].figures;
    EXPECT_EQ(fit.points, 101 * 101);
    EXPECT_LT(fit.rms, 0.3);
    EXPECT_LE(fit.median, fit.p95);
    EXPECT_LE(fit.p95, fit.max);
    EXPECT_GT(fit.coverage, 0.97);
    EXPECT_EQ(result.report.constraints.ghost, static_cast<std::int64_t>(result.surface->positions.size()));
}

TEST(Scan, FineDetailSurvives)
{
    // 12 mm wide, 4 mm deep.
    const auto steep = [](double, double y) { return std::abs(y - 150) < 6 ? -4.0 : 0.0; };
    const auto round = [](double, double y) {
        return std::abs(y - 150) < 6 ? -2 * (1 + std::cos((y - 150) * std::numbers::pi / 6)) : 0.0;
    };
    Scan scan;
    scan.strength = 30;
    for (const Height& groove : {Height(steep), Height(round)}) {
        const SolveResult result = fitted(withScan(heldSquare(300, 3), scan, scanOf(groove, 300, 3)));
        for (const double x : {50.0, 150.0, 250.0})
            EXPECT_LT(heightAt(*result.surface, x, 150), -3) << x;
        EXPECT_NEAR(heightAt(*result.surface, 150, 100), 0, 0.3);
    }
}

TEST(Scan, AHoleIsSpannedSmoothly)
{
    PointCloud cloud = scanOf(bump, 300, 3);
    std::erase_if(cloud.points, [](const Vec3& p) { return (p.head<2>() - Vec2(150, 150)).norm() < 40; });
    const SolveResult result = fitted(withScan(heldSquare(300, 8), {}, std::move(cloud)));
    EXPECT_NEAR(heightAt(*result.surface, 150, 150), 12, 1.5);
    EXPECT_LT(result.report.scans.at(0).figures.coverage, 0.96);
}

TEST(Scan, OneThatIsOffOrTooFarChangesNothingButIsMeasured)
{
    const Design design = heldSquare(300, 10);
    const SurfaceMesh without = *fitted(design).surface;
    Scan off;
    off.enabled = false;
    const SolveResult measured = fitted(withScan(design, off, scanOf(bump, 300, 5)));
    EXPECT_EQ(measured.surface->positions, without.positions);
    EXPECT_NEAR(measured.report.scans.at(0).figures.max, 12, 0.5);

    Scan far;
    far.position.z() = 100;
    const SolveResult away = fitted(withScan(design, far, scanOf(bump, 300, 5)));
    EXPECT_EQ(away.report.scans.at(0).figures.coverage, 0);
    double farthest = 0;
    for (std::size_t v = 0; v < without.positions.size(); ++v)
        farthest = std::max(farthest, (away.surface->positions[v] - without.positions[v]).norm());
    EXPECT_LT(farthest, 0.1);
}

TEST(Scan, DeviationsArePositiveOutside)
{
    const SolveResult flat = fitted(heldSquare(300, 10));
    Scan scan;
    scan.position.z() = -5;
    WorkerPool pool(1);
    const PointCloud cloud = scanOf([](double, double) { return 0.0; }, 300, 5);
    const ScanDeviation deviation =
        measureScan(*flat.surface, scan, std::make_shared<const ScanIndex>(cloud, scan.cuts), pool);
    for (const float value : deviation.ofVertex)
        EXPECT_NEAR(value, 5, 1e-3);

    scan.enabled = false; // it may be measured nevertheless
    const SolveInput input = withScan(heldSquare(300, 10), scan, cloud);
    const CoverMap map = coverMap(CoverMap::Kind::Deviation, *flat.surface, input.design, input.files);
    EXPECT_EQ(map.ofVertex, deviation.ofVertex);
    EXPECT_EQ(map.scale.limit, 5);
}

TEST(Scan, TheFitIsTheSameOnAnyNumberOfThreads)
{
    Scan scan;
    scan.strength = 3;
    const SolveInput input = withScan(heldSquare(300, 6), scan, scanOf(bump, 300, 4));
    const SolveResult one = fitted(input, 1), two = fitted(input, 2), three = fitted(input, 3);
    EXPECT_EQ(one.surface->positions, two.surface->positions);
    EXPECT_EQ(one.surface->positions, three.surface->positions);
}

TEST(Scan, PointsAsTargetsHoldTheClothTighter)
{
    Scan scan;
    scan.target = ScanTarget::Point;
    const SolveInput points = withScan(heldSquare(300, 8), scan, scanOf(bump, 300, 5));
    scan.target = ScanTarget::Plane;
    const SolveInput planes = withScan(heldSquare(300, 8), scan, scanOf(bump, 300, 5));
    EXPECT_GT(fitted(points).report.strain.rms, fitted(planes).report.strain.rms);
}

TEST(Scan, CutsThatLeaveNothingAreAWarning)
{
    Scan scan;
    scan.cuts = {{{{Vec3::UnitZ(), 1000}}, false}};
    const SolveResult result = fitted(withScan(heldSquare(300, 10), scan, scanOf(bump, 300, 5)));
    ASSERT_EQ(result.warnings.size(), 1u);
    EXPECT_EQ(result.warnings[0].field, "cuts");
    EXPECT_TRUE(result.report.scans.empty());
}

/// A box cover, and the same surface as points of another file: in metres, turned and moved.
struct Misplaced {
    SurfaceMesh surface = *solved(box(400, 150, 15, 5, 0.3), 1e-5).surface;
    Placement right{1000, Vec3(50, -20, 30), Quat(Eigen::AngleAxisd(0.5, Vec3(1, 1, 0).normalized()))};
    PointCloud cloud;

    Misplaced()
    {
        for (const auto& [a, b, c] : surface.topology->triangles) {
            const auto& p = surface.positions;
            for (const Vec3& w : {Vec3(0.6, 0.2, 0.2), Vec3(0.2, 0.6, 0.2), Vec3(0.2, 0.2, 0.6)})
                cloud.points.push_back(right.filePoint(w[0] * p[a] + w[1] * p[b] + w[2] * p[c]));
        }
    }

    AlignTarget target() const
    {
        AlignTarget cover;
        cover.add(surface.positions, surface.topology->triangles);
        cover.build();
        return cover;
    }
};

TEST(ScanOnCover, FindsBackFromAFewCentimetresAndDegrees)
{
    Misplaced m;
    std::erase_if(m.cloud.points, [&](const Vec3& p) { return m.right.placed(p).x() < 60; }); // unseen
    const ScanIndex index(m.cloud, {});
    Placement from = m.right;
    from.position += Vec3(12, -18, 15);
    from.rotation = Quat(Eigen::AngleAxisd(0.06, Vec3(1, -2, 1).normalized())) * from.rotation;
    const auto found = alignScan(m.target(), index, from);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->placement.scale, m.right.scale);
    EXPECT_LT(found->rms, 0.1);
    EXPECT_GT(found->matched, 0.99);
    double farthest = 0;
    for (const Vec3& p : m.cloud.points)
        farthest = std::max(farthest, (found->placement.placed(p) - m.right.placed(p)).norm());
    EXPECT_LT(farthest, 0.5);
}

TEST(ScanOnCover, AScanFarAwayIsNotMoved)
{
    const Misplaced m;
    Placement from = m.right;
    from.position.x() += 3000;
    EXPECT_FALSE(alignScan(m.target(), ScanIndex(m.cloud, {}), from));
}

TEST(SolvePlan, KnowsWhatScansAsk)
{
    const SolveInput before = withScan(heldSquare(300, 10), {}, scanOf(bump, 300, 5));
    const ElementId id = before.files.clouds.begin()->first;
    const auto with = [&](auto change) {
        SolveInput after = before;
        Scan scan = *before.design.find<Scan>(id);
        change(scan);
        after.design = before.design.with({{}, {{id, nullptr, makeElement(std::move(scan))}}});
        return planSolve(before, after);
    };
    EXPECT_EQ(with([](Scan& s) { s.name = "Other"; }), SolvePlan::Nothing);
    EXPECT_EQ(with([](Scan& s) { s.position.x() = 1; }), SolvePlan::Retarget);
    EXPECT_EQ(with([](Scan& s) { s.enabled = false; }), SolvePlan::Retarget);
    SolveInput unread = before;
    unread.files = {};
    EXPECT_EQ(planSolve(unread, before), SolvePlan::Retarget);
}

} // namespace
} // namespace bolster::test
