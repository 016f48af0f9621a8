// Surfaces that are known beforehand.
#include "TestDesigns.h"

#include "PreparedSheet.h"
#include "Relaxation.h"
#include "StartPlacement.h"
#include "SurfaceMeasures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster::test {
namespace {

TEST(Analytic, TubeIsACylinder)
{
    constexpr double width = 600, height = 400;
    const double radius = width / (2 * std::numbers::pi);
    const SolveResult result = solved(tube(width, height, 8, 5));
    ASSERT_TRUE(result.surface);
    double largest = 0;
    int count = 0;
    for (std::size_t v = 0; v < result.surface->positions.size(); ++v) {
        const double along = result.surface->topology->pattern[v].y();
        if (along < 100 || along > height - 100)
            continue;
        const double r = result.surface->positions[v].head<2>().norm();
        largest = std::max(largest, std::abs(r / radius - 1));
        ++count;
    }
    EXPECT_GT(count, 500);
    EXPECT_LT(largest, 0.002);
}

TEST(Analytic, NormalsOfATubePointOutside)
{
    const SolveResult result = solved(tube(600, 200, 15, 8), 1e-6);
    for (std::size_t v = 0; v < result.surface->positions.size(); ++v) {
        const Vec3 p = result.surface->positions[v];
        EXPECT_GT(result.surface->normals[v].cast<double>().dot(Vec3(p.x(), p.y(), 0).normalized()), 0.7);
    }
}

TEST(Analytic, PatchFixedToItsOwnOutlineStaysFlat)
{
    DesignBuilder b(10);
    const ElementId patch = b.patch({{0, 0}, {300, 0}, {320, 180}, {150, 240}, {-20, 150}}, b.fabric(0.3, 5));
    b.fix({patch, 0, 0},
          polyline({{0, 0, 50}, {300, 0, 50}, {320, 180, 50}, {150, 240, 50}, {-20, 150, 50}}, true));
    const SolveResult result = solved(b.design());
    EXPECT_LT(result.report.strain.max, 1e-6);
    for (const Vec3& p : result.surface->positions)
        EXPECT_NEAR(p.z(), 50, 1e-4);
    EXPECT_NEAR(result.report.area, result.report.restArea, 1e-6 * result.report.restArea);
}

// In the plane of the arch it would be sheared by 15 %, and stay there for symmetry.
TEST(Analytic, PatchHungFromAnArchBendsWithoutStrain)
{
    DesignBuilder b(20);
    const ElementId patch = b.patch(rectangle(500, 480), b.fabric(0.3, 12));
    b.fix({patch, 0, 1}, BSpline3(3, false, {{0, 0, 0}, {150, 0, 20}, {300, 0, 20}, {500, 0, 0}}));
    const SolveResult result = solved(b.design(), 1e-6);
    EXPECT_LT(result.report.strain.max, 0.01);
    double across = 0;
    for (const Vec3& p : result.surface->positions)
        across = std::max(across, std::abs(p.y()));
    EXPECT_GT(across, 470);
}

/// The width in the middle of a strip that is pulled to 110 % of its length, relative to its rest width, minus 1.
double narrowing(double poisson)
{
    constexpr double length = 400, width = 80, pull = 0.1;
    DesignBuilder b(5);
    const ElementId patch = b.patch(rectangle(length, width), b.fabric(poisson, 3));
    b.fix({patch, 1, 2}, polyline({{length * (1 + pull), 0, 0}, {length * (1 + pull), width, 0}}));
    b.fix({patch, 3, 4}, polyline({{0, width, 0}, {0, 0, 0}}));
    const SolveResult result = solved(b.design());
    double low = 0, high = 0;
    int count = 0;
    const SurfaceMesh& surface = *result.surface;
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        const Vec2 rest = surface.topology->pattern[v];
        if (std::abs(rest.x() - length / 2) > 25)
            continue;
        if (rest.y() < 1e-9) {
            low += surface.positions[v].y();
            ++count;
        }
        if (rest.y() > width - 1e-9)
            high += surface.positions[v].y();
    }
    return 1 - (high - low) / count / width;
}

TEST(Analytic, PulledStripNarrowsByPoissonsRatio)
{
    for (double poisson : {0.0, 0.3, 0.5}) {
        const double expected = poisson * 0.1;
        EXPECT_NEAR(narrowing(poisson), expected, std::max(0.05 * expected, 0.001)) << poisson;
    }
}

TEST(Analytic, StrainDoesNotDependOnTheMesh)
{
    std::vector<double> rms;
    for (double edge : {6.0, 12.0, 24.0}) {
        const SolveResult result = solved(box(500, 100, edge, 12, 0.5));
        EXPECT_EQ(result.report.flippedTriangles, 0);
        rms.push_back(result.report.strain.rms);
    }
    const auto [least, most] = std::minmax_element(rms.begin(), rms.end());
    EXPECT_GT(*least, 0.01);
    EXPECT_LT(*most / *least, 1.02);
}

TEST(Analytic, StifferFabricTakesLessOfTheStretch)
{
    DesignBuilder b(8);
    const ElementId soft = b.patch(rectangle(100, 60), b.fabric(0, 4, 1));
    const ElementId stiff = b.patch(rectangle(100, 60), b.fabric(0, 4, 3));
    b.seam({soft, 1, 2}, {stiff, 3, 4});
    b.fix({soft, 3, 4}, polyline({{0, 60, 0}, {0, 0, 0}}));
    b.fix({stiff, 1, 2}, polyline({{220, 0, 0}, {220, 60, 0}}));
    const SolveResult result = solved(b.design());
    double seamX = 0;
    const auto& chain = result.surface->topology->seams[0].a;
    for (std::uint32_t v : chain)
        seamX += result.surface->positions[v].x() / static_cast<double>(chain.size());
    EXPECT_NEAR(seamX, 115, 0.5); // springs in series: 15 mm and 5 mm
}

/// A flat sheet that is a little too large for its frame, or too long between two edges: symmetry does not keep it
/// flat and pressed together.
TEST(SlackSheet, DomesThoughAllOfItLiesInAPlane)
{
    for (const bool allRound : {true, false})
        for (const double slack : {0.01, 0.02, 0.05}) {
            DesignBuilder b(12);
            const ElementId patch = b.patch(rectangle(400, 300), b.fabric(0.3, 6));
            const double w = (1 - slack) * 400, h = allRound ? (1 - slack) * 300 : 300;
            const std::vector<Vec3> corners{{0, 0, 0}, {w, 0, 0}, {w, h, 0}, {0, h, 0}};
            for (int k = 0; k < 4; ++k)
                if (allRound || k % 2 == 1)
                    b.fix({patch, double(k), double(k + 1)}, polyline({corners[k], corners[(k + 1) % 4]}));
            const SolveResult result = solved(b.design());
            double highest = 0;
            for (const Vec3& place : result.surface->positions)
                highest = std::max(highest, std::abs(place.z()));
            EXPECT_GT(highest, 10) << allRound << " " << slack;
            EXPECT_LT(result.report.strain.rms, 0.95 * slack) << allRound << " " << slack;
        }
}

/// A square fixed to the trapezoid of the paper's Figure 10, in the x-z plane.
constexpr double trapezoidHeight = 391.918;

TEST(Trapezoid, FoldsInsteadOfShrinking)
{
    const SolveResult result = solved(sample("trapezoid"), 1e-6);
    const SurfaceMesh& surface = *result.surface;
    // Depth along the line parallel to the short edge at 15 % of the height, cut through the triangles.
    std::vector<Vec2> line;
    for (const auto& triangle : surface.topology->triangles)
        for (int k = 0; k < 3; ++k) {
            const Vec3 &a = surface.positions[triangle[k]], &b = surface.positions[triangle[(k + 1) % 3]];
            const double level = 0.15 * trapezoidHeight;
            if ((a.z() < level) != (b.z() < level)) {
                const Vec3 p = a + (level - a.z()) / (b.z() - a.z()) * (b - a);
                line.emplace_back(p.x(), p.y());
            }
        }
    ASSERT_GT(line.size(), 50u);
    std::sort(line.begin(), line.end(), [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
    Eigen::MatrixXd powers(line.size(), 3);
    Eigen::VectorXd depth(line.size());
    for (std::size_t i = 0; i < line.size(); ++i) {
        powers.row(i) << 1, line[i].x(), line[i].x() * line[i].x();
        depth[i] = line[i].y();
    }
    const Eigen::VectorXd rest = depth - powers * powers.colPivHouseholderQr().solve(depth).eval();
    int changes = 0;
    for (Eigen::Index i = 1; i < rest.size(); ++i)
        changes += (rest[i] > 0) != (rest[i - 1] > 0);
    EXPECT_GE(changes, 4);
    EXPECT_GT(rest.cwiseAbs().maxCoeff(), 2.0) << "ripples, not noise";
}

TEST(Trapezoid, FoldsReleaseTheCompression)
{
    const Design design = sample("trapezoid");
    TriangulationCache cache;
    const std::optional<PreparedSheet> sheet = prepareSheet(design, cache);
    WorkerPool pool(2);
    Relaxation flat(sheet->mesh, pool, 1e-6);
    flat.startFrom(startPlacement(sheet->mesh), true); // no seed: stays on the saddle
    while (flat.phase() == Relaxation::Phase::Running && flat.iterations() < 60)
        flat.iterate();
    const SolveReport flatReport = measureSurface(*sheet, flat.state());
    double thickness = 0;
    for (Eigen::Index u = 0; u < flat.state().positions.cols(); ++u)
        thickness = std::max(thickness, std::abs(flat.state().positions(1, u)));
    ASSERT_LT(thickness, 0.1) << "the reference must be flat";
    EXPECT_LE(solved(design, 1e-6).report.strain.rms, 0.7 * flatReport.strain.rms);
}

} // namespace
} // namespace bolster::test
