#include "CoverSolid.h"
#include "CoverBuilder.h"
#include "CoverRefiner.h"
#include "CustomerPage.h"
#include "IsoSurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace bolster {
namespace {

using test::CoverBuilder;

/// Each edge once in each direction; points that lie at one place are one, as they are in an STL.
::testing::AssertionResult isClosed(const TriangleMesh& mesh)
{
    std::map<std::array<float, 3>, int> places;
    std::vector<int> place;
    for (const Vec3& p : mesh.points)
        place.push_back(
            places
                .try_emplace({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())},
                             static_cast<int>(places.size()))
                .first->second);
    std::map<std::pair<int, int>, int> edges;
    for (const auto& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            ++edges[{place[t[i]], place[t[(i + 1) % 3]]}];
    for (const auto& [edge, count] : edges)
        if (count != 1 || !edges.contains({edge.second, edge.first}))
            return ::testing::AssertionFailure() << "an edge that is there " << count << " times";
    return mesh.triangles.empty() ? ::testing::AssertionFailure() << "empty" : ::testing::AssertionSuccess();
}

TriangleMesh solidOf(const CoverBuilder& builder, double thickness)
{
    return coverSolid(*CoverRefiner().refine(builder.cover(), 1), thickness);
}

TEST(CoverSolid, IsAsThickAsTheMaterial)
{
    CoverBuilder builder;
    builder.grid({200, 100}, 10, 5, [](const Vec2& p) { return Vec3(p.x(), p.y(), 7); });
    const TriangleMesh solid = solidOf(builder, 2);
    EXPECT_TRUE(isClosed(solid));
    EXPECT_NEAR(enclosedVolume(solid), 200 * 100 * 2, 1);
    EXPECT_NEAR(solid.boundingBox().min().z(), 5, 1e-4) << "its outside stays where it is";
    EXPECT_NEAR(solid.boundingBox().max().z(), 7, 1e-4);
}

TEST(CoverSolid, GoesOnAcrossSeamsAndAroundEdges)
{
    CoverBuilder builder;
    const auto top = builder.grid({100, 100}, 5, 5, [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); });
    const auto side = builder.grid({100, 100}, 5, 5, [](const Vec2& p) { return Vec3(100, p.y(), -p.x()); });
    builder.sew(builder.side(top, CoverBuilder::Side::Right), builder.side(side, CoverBuilder::Side::Left),
                Continuity::C0);
    const TriangleMesh solid = solidOf(builder, 3);
    EXPECT_TRUE(isClosed(solid));
    EXPECT_NEAR(enclosedVolume(solid), 2 * 100 * 100 * 3 - 100 * 3 * 3, 200) << "as thick at the edge as beside it";
}

TEST(CoverSolid, KeepsSheetsApartWhereThreePatchesMeet)
{
    CoverBuilder builder;
    const auto a = builder.grid({100, 100}, 5, 5, [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); });
    const auto b = builder.grid({100, 100}, 5, 5, [](const Vec2& p) { return Vec3(100 + p.x(), p.y(), 0); });
    const auto c = builder.grid({100, 100}, 5, 5, [](const Vec2& p) { return Vec3(100, p.y(), -p.x()); });
    const auto seam = builder.side(a, CoverBuilder::Side::Right);
    builder.sew(seam, builder.side(b, CoverBuilder::Side::Left), Continuity::C0);
    builder.sew(seam, builder.side(c, CoverBuilder::Side::Left), Continuity::C0);
    const TriangleMesh solid = solidOf(builder, 2);
    EXPECT_TRUE(isClosed(solid));
    EXPECT_NEAR(enclosedVolume(solid), 3 * 100 * 100 * 2, 1000);
}

TEST(CoverSolid, IsoSurfacesAreClosedAndWhereTheValuesSay)
{
    const Box3 box(Vec3::Constant(-40), Vec3::Constant(40));
    const VoxelGrid grid = VoxelGrid::around(box, 5, 1);
    std::vector<float> values(grid.voxelCount());
    for (int z = 0; z < grid.size[2]; ++z)
        for (int y = 0; y < grid.size[1]; ++y)
            for (int x = 0; x < grid.size[0]; ++x)
                values[grid.index(x, y, z)] = static_cast<float>(30 - grid.centre(x, y, z).norm());
    const TriangleMesh ball = isoSurface(grid, values);
    EXPECT_TRUE(isClosed(ball));
    EXPECT_NEAR(enclosedVolume(ball) / (4.0 / 3 * std::numbers::pi * 30 * 30 * 30), 1, 0.02);
    for (const Vec3& p : ball.points)
        EXPECT_NEAR(p.norm(), 30, 0.7);
}

TEST(CustomerPage, WritesBase64)
{
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

} // namespace
} // namespace bolster
