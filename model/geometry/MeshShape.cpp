#include "MeshShape.h"

#include <cmath>
#include <numbers>

namespace bolster {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Twice the area long.
std::vector<Vec3> faceNormals(std::span<const Vec3> points, std::span<const Triangle> triangles)
{
    std::vector<Vec3> normals;
    normals.reserve(triangles.size());
    for (const Triangle& t : triangles) {
        const Vec3 n = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
        normals.push_back(n.allFinite() ? n : Vec3(Vec3::Zero()));
    }
    return normals;
}

} // namespace

std::vector<std::array<Eigen::Vector3f, 3>> cornerNormals(std::span<const Vec3> points,
                                                          std::span<const Triangle> triangles, double crease)
{
    const std::vector<Vec3> faces = faceNormals(points, triangles);
    std::vector<std::vector<std::uint32_t>> around(points.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (const std::uint32_t corner : triangles[t])
            around[corner].push_back(t);

    const double limit = std::cos(crease);
    std::vector<std::array<Eigen::Vector3f, 3>> result(triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const double size = faces[t].norm();
        for (std::size_t i = 0; i < 3; ++i) {
            Vec3 sum = Vec3::Zero();
            for (const std::uint32_t other : around[triangles[t][i]])
                if (faces[other].dot(faces[t]) >= limit * size * faces[other].norm())
                    sum += faces[other];
            result[t][i] =
                sum.squaredNorm() > 0 ? Eigen::Vector3f(sum.normalized().cast<float>()) : Eigen::Vector3f(0, 0, 1);
        }
    }
    return result;
}

double frontAzimuth(std::span<const Vec3> points)
{
    Box3 box;
    for (const Vec3& p : points)
        if (p.allFinite())
            box.extend(p);
    if (box.isEmpty())
        return 0;
    const double high = box.min().z() + 0.75 * box.sizes().z();
    Vec2 top = Vec2::Zero(), all = Vec2::Zero();
    double topCount = 0, count = 0;
    for (const Vec3& p : points) {
        if (!p.allFinite())
            continue;
        all += p.head<2>();
        ++count;
        if (p.z() >= high) {
            top += p.head<2>();
            ++topCount;
        }
    }
    const Vec2 back = top / topCount - all / count;
    if (back.norm() < 0.08 * box.sizes().head<2>().norm())
        return 0;
    constexpr double right = std::numbers::pi / 2;
    if (std::abs(back.x()) > std::abs(back.y()))
        return back.x() > 0 ? -right : right;
    return back.y() > 0 ? 0 : 2 * right;
}

} // namespace bolster
