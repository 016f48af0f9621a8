#include "PatchTriangulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace bolster {
namespace {

std::vector<Vec2> flower(int count, double size, double depth)
{
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * EIGEN_PI * i / count;
        points.push_back(size * (1 + depth * std::cos(5 * angle)) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

double area(const std::vector<Vec2>& p)
{
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2 &a = p[i], &b = p[(i + 1) % p.size()];
        sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    return sum;
}

double triangleArea(const PatchMesh& mesh, const std::array<int, 3>& t)
{
    const Vec2 u = mesh.points[t[1]] - mesh.points[t[0]], v = mesh.points[t[2]] - mesh.points[t[0]];
    return 0.5 * (u.x() * v.y() - u.y() * v.x());
}

void expectWholeAndOriented(const PatchMesh& mesh, const std::vector<Vec2>& boundary)
{
    ASSERT_FALSE(mesh.triangles.empty());
    ASSERT_EQ(mesh.boundaryCount, static_cast<int>(boundary.size()));
    for (std::size_t i = 0; i < boundary.size(); ++i)
        EXPECT_EQ(mesh.points[i], boundary[i]);
    double sum = 0;
    std::map<std::pair<int, int>, int> edges;
    for (const auto& t : mesh.triangles) {
        EXPECT_GT(triangleArea(mesh, t), 0);
        sum += triangleArea(mesh, t);
        for (int k = 0; k < 3; ++k)
            ++edges[std::minmax(t[k], t[(k + 1) % 3])];
    }
    EXPECT_NEAR(sum, std::abs(area(boundary)), 1e-9 * sum);
    for (int i = 0; i < mesh.boundaryCount; ++i)
        EXPECT_EQ((edges[std::minmax(i, (i + 1) % mesh.boundaryCount)]), 1) << "an outline edge has been split";
}

TEST(PatchTriangulator, KeepsTheOutline)
{
    std::vector<Vec2> boundary = flower(120, 200, 0.25);
    expectWholeAndOriented(triangulatePatch(boundary, 10), boundary);
    std::reverse(boundary.begin(), boundary.end());
    expectWholeAndOriented(triangulatePatch(boundary, 10), boundary);
}

TEST(PatchTriangulator, MakesRoundTriangles)
{
    const PatchMesh mesh = triangulatePatch(flower(130, 200, 0), 200 * 2 * EIGEN_PI / 130);
    double least = EIGEN_PI;
    for (const auto& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const Vec2 u = (mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]]).normalized();
            const Vec2 v = (mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]]).normalized();
            least = std::min(least, std::acos(u.dot(v)));
        }
    EXPECT_GT(least * 180 / EIGEN_PI, 28);
}

TEST(PatchTriangulator, IsTheSameEveryTime)
{
    const std::vector<Vec2> boundary = flower(90, 150, 0.2);
    const PatchMesh a = triangulatePatch(boundary, 8), b = triangulatePatch(boundary, 8);
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.triangles, b.triangles);
}

/// The larger of the two angles' sums that lie opposite to an inner edge, over all of them: pi at most if no point
/// lies in the circle round another triangle.
double largestOppositeAngles(const PatchMesh& mesh)
{
    std::map<std::pair<int, int>, std::vector<double>> opposite;
    for (const auto& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const Vec2 u = (mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]]).normalized();
            const Vec2 v = (mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]]).normalized();
            opposite[std::minmax(t[(k + 1) % 3], t[(k + 2) % 3])].push_back(std::acos(u.dot(v)));
        }
    for (const std::vector<int>& line : mesh.lines)
        for (std::size_t k = 0; k + 1 < line.size(); ++k)
            opposite.erase(std::minmax(line[k], line[k + 1]));
    double largest = 0;
    for (const auto& [edge, angles] : opposite)
        if (angles.size() == 2)
            largest = std::max(largest, angles[0] + angles[1]);
    return largest;
}

/// Most of it is filled without a triangulation, but as one would.
TEST(PatchTriangulator, FillsLargePatchesAsSmallOnes)
{
    const std::vector<Vec2> boundary = flower(900, 600, 0.25);
    InnerLine across, button;
    across.points = {boundary[0]};
    for (int i = 1; i <= 40; ++i)
        across.points.emplace_back(boundary[0] + Vec2(-10.0 * i, 3 * std::sin(0.3 * i)));
    across.startSample = 0;
    // So small that it lies between three seeds.
    button.points = {{-310.1, 80}, {-309.8, 80.1}, {-310, 80.3}};
    button.closed = true;
    const PatchMesh mesh = triangulatePatch(boundary, 5, {across, button});
    expectWholeAndOriented(mesh, boundary);
    const auto inner = std::ssize(mesh.points) - mesh.boundaryCount;
    EXPECT_GT(inner, 40'000);
    EXPECT_EQ(std::ssize(mesh.triangles), mesh.boundaryCount + 2 * inner - 2) << "a disc";
    EXPECT_LT(largestOppositeAngles(mesh), EIGEN_PI + 1e-9);
    std::vector<char> used(mesh.points.size(), 0);
    for (const auto& t : mesh.triangles)
        for (int corner : t)
            used[corner] = 1;
    EXPECT_EQ(std::ranges::count(used, 0), 0);
}

TEST(PatchTriangulator, TakesPatchesSmallerThanAnEdge)
{
    const std::vector<Vec2> boundary{{0, 0}, {3, 0}, {0, 2}};
    const PatchMesh mesh = triangulatePatch(boundary, 50);
    EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(PatchTriangulator, RefusesAnOutlineThatCrossesItself)
{
    EXPECT_TRUE(triangulatePatch({{0, 0}, {100, 0}, {0, 100}, {100, 100}}, 10).triangles.empty());
    EXPECT_TRUE(triangulatePatch({{0, 0}, {100, 0}, {100, 100}, {50, 0}, {0, 100}}, 10).triangles.empty());
}

} // namespace
} // namespace bolster
