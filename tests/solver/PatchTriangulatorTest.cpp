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
