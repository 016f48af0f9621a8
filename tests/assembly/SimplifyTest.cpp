// Frames with fewer triangles keep their shape, their parts, and stay closed.
#include "SimplifyMesh.h"

#include "HalfEdges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {
namespace {

/// A ball of radius 100; its northern half is a part of its own that shares the equator's points.
TriangleMesh ball(std::uint32_t rows)
{
    TriangleMesh mesh;
    const std::uint32_t columns = 2 * rows;
    for (std::uint32_t row = 1; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const double polar = std::numbers::pi * row / rows, around = std::numbers::pi * column / rows;
            mesh.points.emplace_back(100 * std::sin(polar) * std::cos(around),
                                     100 * std::sin(polar) * std::sin(around), 100 * std::cos(polar));
        }
    const auto north = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.emplace_back(0, 0, 100);
    mesh.points.emplace_back(0, 0, -100);
    const auto at = [&](std::uint32_t row, std::uint32_t column) {
        return row == 0 ? north : row == rows ? north + 1 : (row - 1) * columns + column % columns;
    };
    for (std::uint32_t row = 0; row < rows; ++row) {
        if (row == rows / 2)
            mesh.parts = {{"North", 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
        for (std::uint32_t column = 0; column < columns; ++column) {
            if (row > 0)
                mesh.triangles.push_back({at(row, column), at(row + 1, column), at(row, column + 1)});
            if (row + 1 < rows)
                mesh.triangles.push_back({at(row, column + 1), at(row + 1, column), at(row + 1, column + 1)});
        }
    }
    const std::uint32_t first = mesh.parts[0].triangleCount;
    mesh.parts.push_back({"South", first, static_cast<std::uint32_t>(mesh.triangles.size()) - first});
    return mesh;
}

/// As many triangles at one side of each edge as at the other.
bool isClosed(const TriangleMesh& mesh)
{
    bool closed = true;
    eachEdge(halfEdges(mesh.triangles), [&](const HalfEdge* first, const HalfEdge* last) {
        closed =
            closed && 2 * std::count_if(first, last, [](const HalfEdge& h) { return h.forward; }) == last - first;
    });
    return closed;
}

double volume(const TriangleMesh& mesh)
{
    double six = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        six += mesh.points[a].dot(mesh.points[b].cross(mesh.points[c]));
    return six / 6;
}

TEST(Simplify, KeepsShapeAndPartsAndStaysClosed)
{
    const TriangleMesh before = ball(80);
    ASSERT_TRUE(isClosed(before));
    const SimplifiedMesh fewer = simplified(before, {}, 3000);
    EXPECT_LT(fewer.mesh.triangles.size(), 3600u) << "those at the equator stay";
    EXPECT_GT(fewer.mesh.triangles.size(), 1500u);
    EXPECT_TRUE(isClosed(fewer.mesh)) << "parts share their points";
    EXPECT_NEAR(volume(fewer.mesh), volume(before), 0.01 * volume(before));
    EXPECT_GT(fewer.off, 0);
    EXPECT_LT(fewer.off, 2);
    ASSERT_EQ(fewer.mesh.parts.size(), 2u);
    EXPECT_EQ(fewer.mesh.parts[0].name, "North");
    EXPECT_EQ(fewer.mesh.parts[1].firstTriangle, fewer.mesh.parts[0].triangleCount);
    for (const Vec3& point : fewer.mesh.points)
        EXPECT_NEAR(point.norm(), 100, 1e-9) << "points of the mesh";
}

/// Piece by piece: the borders between pieces are not to be seen in the result.
TEST(Simplify, VeryLargeMeshesToo)
{
    TriangleMesh before = ball(640);
    before.parts = {{"Ball", 0, static_cast<std::uint32_t>(before.triangles.size())}};
    ASSERT_GT(before.triangles.size(), 1'600'000u);
    const SimplifiedMesh fewer = simplified(before, {}, 20'000);
    EXPECT_LE(fewer.mesh.triangles.size(), 20'000u);
    EXPECT_GT(fewer.mesh.triangles.size(), 15'000u);
    EXPECT_TRUE(isClosed(fewer.mesh));
    EXPECT_NEAR(volume(fewer.mesh), volume(before), 0.002 * volume(before));
    EXPECT_LT(fewer.off, 1);
    double longest = 0; // of the edges: pieces that were left alone would have the shortest ones beside long ones
    for (const auto& [a, b, c] : fewer.mesh.triangles)
        longest = std::max({longest, (fewer.mesh.points[a] - fewer.mesh.points[b]).norm(),
                            (fewer.mesh.points[b] - fewer.mesh.points[c]).norm()});
    EXPECT_LT(longest, 15);

    const SimplifiedMesh half = simplified(before, {}, before.triangles.size() / 2);
    EXPECT_LE(half.mesh.triangles.size(), before.triangles.size() / 2 + 20'000);
    EXPECT_TRUE(isClosed(half.mesh));
}

TEST(Simplify, LeavesNoFinsAndPockets)
{
    constexpr std::uint32_t cells = 1000;
    TriangleMesh dome;
    for (std::uint32_t row = 0; row <= cells; ++row)
        for (std::uint32_t column = 0; column <= cells; ++column) {
            const double x = 0.2 * column, y = 0.2 * row;
            dome.points.emplace_back(x, y, 60 - ((x - 100) * (x - 100) + (y - 100) * (y - 100)) / 400);
        }
    const auto at = [](std::uint32_t row, std::uint32_t column) { return row * (cells + 1) + column; };
    for (std::uint32_t row = 0; row < cells; ++row)
        for (std::uint32_t column = 0; column < cells; ++column) {
            dome.triangles.push_back({at(row, column), at(row, column + 1), at(row + 1, column + 1)});
            dome.triangles.push_back({at(row, column), at(row + 1, column + 1), at(row + 1, column)});
        }
    dome.parts = {{"Dome", 0, static_cast<std::uint32_t>(dome.triangles.size())}};
    std::vector<std::array<int, 3>> corners;
    for (const auto& [a, b, c] : simplified(dome, {}, 300'000).mesh.triangles)
        corners.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
    int crowded = 0;
    eachEdge(halfEdges(corners), [&](const HalfEdge* first, const HalfEdge* last) { crowded += last - first > 2; });
    EXPECT_EQ(crowded, 0) << "the library leaves some fifty";
}

TEST(Simplify, LeavesOutWhatIsNotWanted)
{
    const SimplifiedMesh south = simplified(ball(40), {false, true}, 500);
    ASSERT_EQ(south.mesh.parts.size(), 1u);
    EXPECT_EQ(south.mesh.parts[0].name, "South");
    EXPECT_LT(south.mesh.boundingBox().max().z(), 1e-9);
}

TEST(Simplify, FarFromTheOriginItIsAsFine)
{
    TriangleMesh far = ball(40);
    far.parts = {{"Ball", 0, static_cast<std::uint32_t>(far.triangles.size())}};
    for (Vec3& point : far.points)
        point += Vec3(4e6, 4e6, 0);
    const SimplifiedMesh fewer = simplified(far, {}, 800);
    EXPECT_LE(fewer.mesh.triangles.size(), 800u);
    EXPECT_LT(fewer.off, 5);
}

TEST(Simplify, NothingAndStoppedIsNothing)
{
    EXPECT_TRUE(simplified({}, {}, 100).mesh.triangles.empty());
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(simplified(ball(20), {}, 100, stop.get_token()).mesh.triangles.empty());
}

} // namespace
} // namespace bolster
