#include "TestMeshes.h"

#include <algorithm>
#include <cmath>

namespace bolster::test {

namespace {

/// The square u, v of a cube's face, from a corner of it.
void addFace(TriangleMesh& mesh, const Vec3& corner, const Vec3& u, const Vec3& v, int count)
{
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    const auto row = static_cast<std::uint32_t>(count + 1);
    for (int j = 0; j <= count; ++j)
        for (int i = 0; i <= count; ++i)
            mesh.points.emplace_back(corner + u * i / count + v * j / count);
    for (std::uint32_t j = 0; j + 1 < row; ++j)
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = first + j * row + i;
            mesh.triangles.push_back({a, a + 1, a + row + 1});
            mesh.triangles.push_back({a, a + row + 1, a + row});
        }
}

/// The cube [-1, 1]^3, each face with points of its own.
TriangleMesh cube(int count)
{
    TriangleMesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {-1, 1}) {
            Vec3 u = Vec3::Zero(), v = Vec3::Zero(), corner = Vec3::Constant(-1);
            u[(axis + 1) % 3] = 2;
            v[(axis + 2) % 3] = 2;
            corner[axis] = side;
            if (side > 0)
                addFace(mesh, corner, u, v, count);
            else
                addFace(mesh, corner, v, u, count);
        }
    return mesh;
}

} // namespace

TriangleMesh boxMesh(const Box3& box)
{
    TriangleMesh mesh = cube(1);
    for (Vec3& p : mesh.points)
        p = box.center() + 0.5 * box.sizes().cwiseProduct(p);
    mesh.parts = {{"Box", 0, 12}};
    return mesh;
}

TriangleMesh sphereMesh(double radius, int count)
{
    TriangleMesh mesh = cube(count);
    for (Vec3& p : mesh.points)
        p = radius * p.normalized();
    mesh.parts = {{"Sphere", 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
    return mesh;
}

void removeFace(TriangleMesh& mesh, int axis, double value)
{
    std::erase_if(mesh.triangles, [&](const auto& triangle) {
        return std::all_of(triangle.begin(), triangle.end(),
                           [&](std::uint32_t corner) { return std::abs(mesh.points[corner][axis] - value) < 1; });
    });
    mesh.parts[0].triangleCount = static_cast<std::uint32_t>(mesh.triangles.size());
}

TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b)
{
    TriangleMesh both = a;
    const auto points = static_cast<std::uint32_t>(a.points.size()),
               faces = static_cast<std::uint32_t>(a.triangles.size());
    both.points.insert(both.points.end(), b.points.begin(), b.points.end());
    for (const auto& [i, j, k] : b.triangles)
        both.triangles.push_back({i + points, j + points, k + points});
    for (TriangleMesh::Part part : b.parts) {
        part.firstTriangle += faces;
        both.parts.push_back(part);
    }
    return both;
}

Vec3 triangleMiddle(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle)
{
    return (mesh.points[triangle[0]] + mesh.points[triangle[1]] + mesh.points[triangle[2]]) / 3;
}

} // namespace bolster::test
