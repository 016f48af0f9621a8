#include "FrameSkin.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace bolster::test {
namespace {

/// A flat cover at height 0, seen from above, from 0 to `size` in x and y, mm.
SurfaceMesh coverAtHeightZero(double size)
{
    auto topology = std::make_shared<SurfaceTopology>();
    topology->triangles = {{0, 1, 2}, {0, 2, 3}};
    topology->pattern.resize(4);
    SurfaceMesh cover;
    cover.topology = topology;
    cover.positions = {{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}};
    cover.normals.assign(4, Eigen::Vector3f::UnitZ());
    return cover;
}

TriangleMesh solidBox(const Vec3& low, const Vec3& high)
{
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.points.emplace_back((corner & 1 ? high : low).x(), (corner & 2 ? high : low).y(),
                                 (corner & 4 ? high : low).z());
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    mesh.parts = {{"box", 0, 12}};
    return mesh;
}

double highestWithin(const FrameSkin& skin, const Box3& within)
{
    double top = -1e9;
    for (const FrameSkin::Corner& corner : skin.corners)
        if (const Vec3 p = corner.position.cast<double>(); within.contains(Vec3(p.x(), p.y(), 0)))
            top = std::max(top, p.z());
    return top;
}

TEST(FrameSkin, FoamGivesUnderTheCover)
{
    const SurfaceMesh cover = coverAtHeightZero(400);
    const TriangleMesh seat = solidBox({50, 50, -200}, {350, 350, 30}); // 30 mm too high for its cover
    const FrameSkinPtr skin = FrameSkins(&cover).skin(seat, {});
    EXPECT_LT(highestWithin(*skin, Box3(Vec3(60, 60, -1), Vec3(340, 340, 1))), -1);
    const FrameSkinPtr alone = FrameSkins(nullptr).skin(seat, {});
    EXPECT_EQ(alone->corners.size(), 36u);
    EXPECT_EQ(highestWithin(*alone, Box3(Vec3(0, 0, -1), Vec3(400, 400, 1))), 30);
}

TEST(FrameSkin, WhatStandsBesideTheCoverStays)
{
    const SurfaceMesh cover = coverAtHeightZero(400);
    const TriangleMesh leg = solidBox({410, 50, -200}, {450, 90, 60});
    const FrameSkinPtr skin = FrameSkins(&cover).skin(leg, {});
    EXPECT_EQ(highestWithin(*skin, Box3(Vec3(400, 0, -1), Vec3(500, 100, 1))), 60);
    const TriangleMesh lamp = solidBox({100, 100, 200}, {300, 300, 260}); // far above
    EXPECT_EQ(highestWithin(*FrameSkins(&cover).skin(lamp, {}), Box3(Vec3(0, 0, -1), Vec3(400, 400, 1))), 260);
}

TEST(FrameSkin, PartOfAFrameIsCoveredWithoutAGap)
{
    const SurfaceMesh cover = coverAtHeightZero(400);
    const TriangleMesh rail = solidBox({100, 100, -50}, {900, 200, 25}); // the cover ends in its middle
    const FrameSkinPtr skin = FrameSkins(&cover).skin(rail, {});
    EXPECT_LT(highestWithin(*skin, Box3(Vec3(110, 110, -1), Vec3(380, 190, 1))), -1);
    EXPECT_NEAR(highestWithin(*skin, Box3(Vec3(430, 110, -1), Vec3(890, 190, 1))), 25, 1e-4);
    using Place = std::array<float, 3>;
    const auto place = [&](std::size_t corner) {
        const auto& p = skin->corners[corner].position;
        return Place{p.x(), p.y(), p.z()};
    };
    std::set<std::pair<Place, Place>> edges;
    for (std::size_t i = 0; i < skin->corners.size(); ++i)
        edges.insert({place(i), place(i - i % 3 + (i + 1) % 3)});
    for (const auto& [from, to] : edges)
        EXPECT_TRUE(edges.contains({to, from})) << "an edge with a triangle on one side only";
}

TEST(FrameSkin, WhereTheCoverEndsInAFrameThatIsNotTorn)
{
    const SurfaceMesh cover = coverAtHeightZero(400);
    const TriangleMesh block = solidBox({300, 100, -50}, {900, 200, 100}); // far too high for foam near the border
    const FrameSkinPtr skin = FrameSkins(&cover).skin(block, {});
    EXPECT_GT(highestWithin(*skin, Box3(Vec3(385, 110, -1), Vec3(399, 190, 1))), 65);
    double steepest = 0; // of the top
    for (std::size_t i = 0; i < skin->corners.size(); ++i) {
        const auto& a = skin->corners[i].position;
        const auto& b = skin->corners[i - i % 3 + (i + 1) % 3].position;
        if (a.z() > 60 && b.z() > 60 && (a - b).head<2>().norm() > 1)
            steepest = std::max(steepest, static_cast<double>(std::abs(a.z() - b.z()) / (a - b).head<2>().norm()));
    }
    EXPECT_LT(steepest, 3);
}

TEST(FrameSkin, FilesThatAreInsideOutAreTheSame)
{
    const SurfaceMesh cover = coverAtHeightZero(400);
    TriangleMesh seat = solidBox({50, 50, -200}, {350, 350, 30});
    for (auto& triangle : seat.triangles)
        std::swap(triangle[0], triangle[1]);
    EXPECT_LT(highestWithin(*FrameSkins(&cover).skin(seat, {}), Box3(Vec3(60, 60, -1), Vec3(340, 340, 1))), -1);
}

TEST(FrameSkin, GrainRunsAlongAPartWhereverItIsPlaced)
{
    Placement placement;
    placement.scale = 10;
    placement.position = Vec3(500, 0, 0);
    placement.rotation = Quat(Eigen::AngleAxisd(1, Vec3::UnitY()));
    const FrameSkinPtr skin = FrameSkins(nullptr).skin(solidBox({0, 0, 0}, {60, 4, 3}), placement);
    double low = 1e9, high = -1e9;
    for (const FrameSkin::Corner& corner : skin->corners) {
        low = std::min(low, static_cast<double>(corner.grain.z()));
        high = std::max(high, static_cast<double>(corner.grain.z()));
    }
    EXPECT_NEAR(high - low, 600, 1e-3);
}

} // namespace
} // namespace bolster::test
