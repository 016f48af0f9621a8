#include "CoverMap.h"
#include "TestDesigns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace bolster::test {
namespace {

/// A grid over [0, width] x [0, height] of the pattern (mm), placed by `place`, as the only patch of `design`.
SurfaceMesh grid(double width, double height, int cells, ElementId patch, ElementId fabric,
                 const std::function<Vec3(const Vec2&)>& place)
{
    auto topology = std::make_shared<SurfaceTopology>();
    SurfaceMesh mesh;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            topology->pattern.push_back({width * i / cells, height * j / cells});
            mesh.positions.push_back(place(topology->pattern.back()));
            topology->unknown.push_back(topology->unknownCount++);
        }
    const auto row = static_cast<std::uint32_t>(cells) + 1;
    for (std::uint32_t j = 0; j + 1 < row; ++j)
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t k = j * row + i;
            topology->triangles.push_back({k, k + 1, k + row + 1});
            topology->triangles.push_back({k, k + row + 1, k + row});
        }
    topology->patches.push_back(
        {patch, fabric, 0, topology->vertexCount(), 0, static_cast<std::uint32_t>(topology->triangles.size()), 0});
    mesh.normals.assign(mesh.positions.size(), Eigen::Vector3f::UnitZ());
    mesh.topology = topology;
    return mesh;
}

struct OnePatch {
    Design design;
    ElementId fabric{};
    ElementId patch{};
};

OnePatch onePatch(double grain, const StretchLimits& limits = {})
{
    DesignBuilder builder(20);
    Fabric fabric;
    fabric.limits = limits;
    const ElementId fabricId = builder.add(fabric);
    Patch patch;
    patch.fabric = fabricId;
    patch.grain = grain;
    const ElementId patchId = builder.add(patch);
    return {builder.design(), fabricId, patchId};
}

float valueOf(CoverMap::Kind kind, const SurfaceMesh& mesh, const Design& design)
{
    return coverMap(kind, mesh, design, {}).ofVertex.at(mesh.positions.size() / 2);
}

TEST(CoverMap, LargestStrainIsTheReports)
{
    DesignBuilder builder(15);
    const ElementId fabric = builder.fabric(0.3, 6);
    const ElementId patch = builder.patch(rectangle(200, 120), fabric);
    builder.fix({patch, 0, 1}, polyline({{0, 0, 0}, {208, 0, 0}}));
    builder.fix({patch, 2, 3}, polyline({{0, 126, 0}, {208, 126, 10}}), true);
    const SolveResult result = solveResting({builder.design()}, {});
    ASSERT_TRUE(result.surface);
    const CoverMap map = coverMap(CoverMap::Kind::Strain, *result.surface, builder.design(), {});
    float largest = 0;
    for (const float percent : map.ofVertex)
        largest = std::max(largest, std::abs(percent));
    EXPECT_GT(result.report.strain.max, 0.01);
    EXPECT_NEAR(static_cast<double>(largest), 100 * result.report.strain.max, 1e-4);
    EXPECT_FLOAT_EQ(worstSpots(map, *result.surface, 1, 10).at(0).value, largest);
}

TEST(CoverMap, GrainSaysWhatIsAlongAndWhatAcross)
{
    for (const double grain : {0.0, 90.0}) {
        OnePatch one = onePatch(grain);
        const SurfaceMesh mesh = grid(100, 100, 4, one.patch, one.fabric,
                                      [](const Vec2& p) { return Vec3(1.05 * p.x(), 0.98 * p.y(), 0); });
        const bool x = grain == 0;
        EXPECT_NEAR(valueOf(CoverMap::Kind::Along, mesh, one.design), x ? 5 : -2, 1e-3);
        EXPECT_NEAR(valueOf(CoverMap::Kind::Across, mesh, one.design), x ? -2 : 5, 1e-3);
        EXPECT_NEAR(valueOf(CoverMap::Kind::Shear, mesh, one.design), 0, 1e-3);
        EXPECT_NEAR(valueOf(CoverMap::Kind::Strain, mesh, one.design), 5, 1e-3);
    }
}

TEST(CoverMap, ShearIsTheTangentOfTheAngle)
{
    const OnePatch one = onePatch(90);
    const SurfaceMesh mesh =
        grid(100, 100, 4, one.patch, one.fabric, [](const Vec2& p) { return Vec3(p.x() + 0.1 * p.y(), p.y(), 0); });
    EXPECT_NEAR(std::abs(valueOf(CoverMap::Kind::Shear, mesh, one.design)), 10, 1e-3);
}

TEST(CoverMap, CurvatureOfATube)
{
    const OnePatch one = onePatch(90);
    constexpr double radius = 50;
    for (const double side : {1.0, -1.0}) { // bulging, hollow
        const SurfaceMesh mesh = grid(100, 100, 40, one.patch, one.fabric, [&](const Vec2& p) {
            const double angle = (p.x() - 50) / radius;
            return Vec3(radius * std::sin(angle), p.y(), side * radius * std::cos(angle));
        });
        EXPECT_NEAR(valueOf(CoverMap::Kind::Curvature, mesh, one.design), side * 1000 / (2 * radius), 0.1);
    }
}

TEST(CoverMap, CurvatureRunsAcrossSeamsAndWhereThreePatchesMeet)
{
    // Two flat strips of 10 x 10 mm, bent by 60 degrees along their seam; a third one stands on it.
    const auto cover = [](bool third) {
        auto topology = std::make_shared<SurfaceTopology>();
        SurfaceMesh mesh;
        const auto strip = [&](const Vec3& out, std::uint32_t firstFree, bool turned) {
            const std::uint32_t at = topology->vertexCount();
            for (const Vec3& p : {Vec3(0, 0, 0), Vec3(0, 10, 0), Vec3(out), Vec3(out + Vec3(0, 10, 0))}) {
                topology->pattern.push_back(p.head<2>());
                mesh.positions.push_back(p);
            }
            topology->unknown.insert(topology->unknown.end(), {0, 1, firstFree, firstFree + 1});
            topology->triangles.push_back(turned ? std::array{at, at + 1, at + 2} : std::array{at, at + 2, at + 1});
            topology->triangles.push_back(turned ? std::array{at + 1, at + 3, at + 2}
                                                 : std::array{at + 1, at + 2, at + 3});
            topology->unknownCount = firstFree + 2;
        };
        const double angle = std::numbers::pi / 3;
        strip({-10, 0, 0}, 2, true);
        strip({10 * std::cos(angle), 0, -10 * std::sin(angle)}, 4, false);
        if (third)
            strip({0, 0, 10}, 6, false);
        mesh.topology = topology;
        return mesh;
    };
    // The seam has 10 mm * 60 degrees / 2, shared by its two ends.
    const SurfaceMesh bent = cover(false);
    const CoverMap map = coverMap(CoverMap::Kind::Curvature, bent, {}, {});
    double bend = 0;
    for (const std::uint32_t v : {0U, 1U}) {
        const double share = v == 0 ? 50.0 / 3 * 2 : 50.0 / 3 * 4; // triangles that meet there
        bend += static_cast<double>(map.ofVertex[v]) / 1000 * share;
    }
    EXPECT_NEAR(bend, 10 * std::numbers::pi / 3 / 2, 1e-5);
    EXPECT_EQ(map.ofVertex[0], map.ofVertex[4]) << "both sides of a seam";

    const CoverMap three = coverMap(CoverMap::Kind::Curvature, cover(true), {}, {});
    for (const float value : three.ofVertex)
        EXPECT_TRUE(std::isfinite(value));
}

TEST(CoverMap, ThicknessIsTheDistanceToTheFrame)
{
    DesignBuilder builder(20);
    Frame frame;
    frame.file = "frame.obj";
    frame.position = {0, 0, -30};
    const ElementId id = builder.add(frame);
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->points = {{-500, -500, 0}, {500, -500, 0}, {0, 900, 0}};
    mesh->triangles = {{0, 1, 2}};
    DesignFiles files;
    files.meshes[id] = mesh;
    const SurfaceMesh cover = grid(100, 100, 4, ElementId{9}, ElementId{8},
                                   [](const Vec2& p) { return Vec3(p.x(), p.y(), 0.1 * p.x()); });
    const CoverMap map = coverMap(CoverMap::Kind::Thickness, cover, builder.design(), files);
    EXPECT_NEAR(map.ofVertex.front(), 30, 1e-3);
    EXPECT_NEAR(map.ofVertex.back(), 40, 1e-3);
    EXPECT_FLOAT_EQ(map.scale.limit, 50);
    const CoverMap without = coverMap(CoverMap::Kind::Thickness, cover, builder.design(), {});
    EXPECT_TRUE(std::isnan(without.ofVertex.front())) << "no frame, no foam";
}

TEST(CoverMap, ShowsWhatIsOverTheFabricsLimit)
{
    const OnePatch one = onePatch(0, {4, 20, 10});
    const SurfaceMesh mesh =
        grid(100, 100, 4, one.patch, one.fabric, [](const Vec2& p) { return Vec3(1.05 * p.x(), 1.05 * p.y(), 0); });
    EXPECT_EQ(coverMap(CoverMap::Kind::Along, mesh, one.design, {}).colors().front(), MapScale::over);
    EXPECT_NE(coverMap(CoverMap::Kind::Across, mesh, one.design, {}).colors().front(), MapScale::over);
    EXPECT_FLOAT_EQ(coverMap(CoverMap::Kind::Across, mesh, one.design, {}).scale.limit, 20);
    const SurfaceMesh pressed =
        grid(100, 100, 4, one.patch, one.fabric, [](const Vec2& p) { return Vec3(0.95 * p.x(), 0.95 * p.y(), 0); });
    EXPECT_EQ(coverMap(CoverMap::Kind::Along, pressed, one.design, {}).colors().front(), MapScale::under)
        << "what folds is told from what tears";
}

TEST(CoverMap, SpotsKeepTheirDistance)
{
    const OnePatch one = onePatch(0);
    const SurfaceMesh mesh = grid(400, 100, 20, one.patch, one.fabric, [](const Vec2& p) {
        return Vec3(p.x() + 0.0002 * p.x() * p.x(), p.y(), 0); // more and more to the right
    });
    const CoverMap map = coverMap(CoverMap::Kind::Along, mesh, one.design, {});
    const std::vector<CoverSpot> spots = worstSpots(map, mesh, 3, 90);
    ASSERT_EQ(spots.size(), 3U);
    EXPECT_GT(spots[0].value, spots[1].value - 1e-3F);
    EXPECT_GT(mesh.positions[spots[0].vertex].x(), 400);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE((mesh.positions[spots[i].vertex] - mesh.positions[spots[j].vertex]).norm(), 90);
}

} // namespace
} // namespace bolster::test
