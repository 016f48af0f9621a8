#include "FoamShape.h"

#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr int around = 48;

Vec3 onCircle(int i, double z, double radius = 1)
{
    const double angle = 2 * std::numbers::pi * i / around;
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// Rings of points around z, from below, with a point at both ends; all within [-1, 1].
TriangleMesh turned(const std::vector<Vec2>& profile)
{
    TriangleMesh mesh;
    for (const Vec2& p : profile)
        for (int i = 0; i < around; ++i)
            mesh.points.push_back(onCircle(i, p.y(), p.x()));
    const auto south = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.emplace_back(0, 0, -1);
    mesh.points.emplace_back(0, 0, 1);
    const auto rings = static_cast<std::uint32_t>(profile.size());
    for (std::uint32_t i = 0; i < around; ++i) {
        const std::uint32_t next = (i + 1) % around, top = (rings - 1) * around;
        mesh.triangles.push_back({south, next, i});
        mesh.triangles.push_back({south + 1, top + i, top + next});
        for (std::uint32_t ring = 0; ring < top; ring += around) {
            mesh.triangles.push_back({ring + i, ring + next, ring + around + next});
            mesh.triangles.push_back({ring + i, ring + around + next, ring + around + i});
        }
    }
    return mesh;
}

TriangleMesh cube()
{
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.points.emplace_back(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

TriangleMesh unitMesh(Foam::Shape shape)
{
    switch (shape) {
    case Foam::Shape::Box:
        return cube();
    case Foam::Shape::Cylinder:
        return turned({{1, -1}, {1, 1}});
    case Foam::Shape::Sphere: {
        std::vector<Vec2> profile;
        for (int i = 1; i < around / 2; ++i) {
            const double angle = 2 * std::numbers::pi * i / around;
            profile.emplace_back(std::sin(angle), -std::cos(angle));
        }
        return turned(profile);
    }
    case Foam::Shape::Mesh:
        break;
    }
    return {};
}

std::vector<std::vector<Vec3>> unitLines(Foam::Shape shape)
{
    std::vector<std::vector<Vec3>> lines;
    if (shape == Foam::Shape::Cylinder) {
        for (const double z : {-1.0, 1.0}) {
            lines.emplace_back();
            for (int i = 0; i <= around; ++i)
                lines.back().push_back(onCircle(i, z));
        }
        for (int i = 0; i < around; i += around / 4)
            lines.push_back({onCircle(i, -1), onCircle(i, 1)});
    } else if (shape == Foam::Shape::Sphere) {
        for (int axis = 0; axis < 3; ++axis) {
            lines.emplace_back();
            for (int i = 0; i <= around; ++i) {
                const Vec3 p = onCircle(i, 0);
                lines.back().emplace_back(p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]);
            }
        }
    } else {
        lines = boxLines(Box3(Vec3(-1, -1, -1), Vec3(1, 1, 1)));
    }
    return lines;
}

} // namespace

TriangleMesh foamMesh(Foam::Shape shape, const Vec3& size)
{
    TriangleMesh mesh = unitMesh(shape);
    for (Vec3& p : mesh.points)
        p = 0.5 * size.cwiseProduct(p);
    if (!mesh.triangles.empty())
        mesh.parts = {{"Foam", 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
    return mesh;
}

std::vector<std::vector<Vec3>> foamLines(Foam::Shape shape, const Vec3& size)
{
    std::vector<std::vector<Vec3>> lines = unitLines(shape);
    for (auto& line : lines)
        for (Vec3& p : line)
            p = 0.5 * size.cwiseProduct(p);
    return lines;
}

std::vector<std::vector<Vec3>> boxLines(const Box3& box)
{
    std::vector<std::vector<Vec3>> lines;
    const auto corner = [&](int i) { return box.corner(static_cast<Box3::CornerType>(i)); };
    for (int i = 0; i < 8; ++i)
        for (const int axis : {1, 2, 4})
            if (!(i & axis))
                lines.push_back({corner(i), corner(i | axis)});
    return lines;
}

} // namespace bolster
