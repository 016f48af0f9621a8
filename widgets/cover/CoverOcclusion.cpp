#include "CoverOcclusion.h"

#include "TriangleRays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

using Vec3f = Eigen::Vector3f;

constexpr int rayCount = 40;
constexpr int groundCount = 72;

/// Directions around +z, more often along it (cosine), turned a little differently for each place.
Vec3f direction(int ray, std::size_t place)
{
    const double turn = static_cast<double>(place % 1024) * 0.618033988749895;
    const double u = (ray + 0.5) / rayCount, v = ray * 0.618033988749895 + turn;
    const double radius = std::sqrt(u), angle = 2 * std::numbers::pi * v;
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1 - u)).cast<float>();
}

float openness(const TriangleRays& rays, const Vec3f& at, const Vec3f& normal, float reach, std::size_t place)
{
    const Vec3f right = normal.unitOrthogonal(), up = normal.cross(right);
    int open = 0;
    for (int ray = 0; ray < rayCount; ++ray) {
        const Vec3f d = direction(ray, place);
        open += !rays.blocked(at, d.x() * right + d.y() * up + d.z() * normal, reach);
    }
    return static_cast<float>(open) / rayCount;
}

/// Neighbours share what they have: few rays leave noise, and it shows as spots.
void smooth(std::vector<float>& values, const SurfaceTopology& topology)
{
    for (int round = 0; round < 2; ++round) {
        std::vector<float> sum = values, weight(values.size(), 1.f);
        for (const auto& t : topology.triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = t[i], b = t[(i + 1) % 3];
                sum[a] += 0.5f * values[b];
                sum[b] += 0.5f * values[a];
                weight[a] += 0.5f;
                weight[b] += 0.5f;
            }
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = sum[i] / weight[i];
    }
}

/// Everything that stands in the light, placed, mm.
struct Obstacles {
    std::vector<Vec3f> points;
    std::vector<TriangleRays::Triangle> triangles;

    void add(const TriangleMesh& mesh, const Placement& placement)
    {
        const auto first = static_cast<std::uint32_t>(points.size());
        for (const Vec3& p : mesh.points)
            points.push_back(placement.placed(p).cast<float>());
        add(mesh.triangles, first);
    }

    void add(const SurfaceMesh& mesh)
    {
        const auto first = static_cast<std::uint32_t>(points.size());
        for (const Vec3& p : mesh.positions)
            points.push_back(p.cast<float>());
        add(mesh.topology->triangles, first);
    }

    void add(const std::vector<TriangleRays::Triangle>& of, std::uint32_t first)
    {
        for (const TriangleRays::Triangle& t : of)
            triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }

    Eigen::AlignedBox3f boundingBox() const
    {
        Eigen::AlignedBox3f box;
        for (const Vec3f& p : points)
            if (p.allFinite())
                box.extend(p);
        return box;
    }

    TriangleRays rays() &&
    {
        TriangleRays rays;
        rays.build(std::move(points), std::move(triangles));
        return rays;
    }
};

/// Without the frames: they touch the cover everywhere.
bool shadeCover(const SurfaceMesh& mesh, float reach, std::stop_token stop, CoverOcclusion& result)
{
    Obstacles cover;
    cover.add(mesh);
    const TriangleRays rays = std::move(cover).rays();
    result.topology = mesh.topology->serial;
    result.outside.assign(mesh.positions.size(), 1.f);
    result.inside = result.outside;
    const float lift = 2e-3f * reach;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (stop.stop_requested())
            return false;
        const Vec3f p = mesh.positions[i].cast<float>(), n = mesh.normals[i];
        if (!p.allFinite() || !(n.squaredNorm() > 0.5f))
            continue;
        result.outside[i] = openness(rays, p + lift * n, n, reach, i);
        result.inside[i] = openness(rays, p - lift * n, -n, reach, i);
    }
    smooth(result.outside, *mesh.topology);
    smooth(result.inside, *mesh.topology);
    return true;
}

/// The same for the ground: the shadow of few rays is blotchy.
void smooth(CoverOcclusion::Ground& ground)
{
    const auto blur = [&](int step, int line) {
        for (int row = 0; row < ground.count; ++row) {
            std::vector<float> values(static_cast<std::size_t>(ground.count));
            const auto at = [&](int i) -> float& {
                return ground
                    .open[static_cast<std::size_t>(row * line + std::clamp(i, 0, ground.count - 1) * step)];
            };
            for (int i = 0; i < ground.count; ++i)
                values[static_cast<std::size_t>(i)] =
                    (at(i - 2) + 2 * at(i - 1) + 3 * at(i) + 2 * at(i + 1) + at(i + 2)) / 9;
            for (int i = 0; i < ground.count; ++i)
                at(i) = values[static_cast<std::size_t>(i)];
        }
    };
    blur(1, ground.count);
    blur(ground.count, 1);
}

bool shadeGround(const TriangleRays& rays, const Eigen::AlignedBox3f& box, float floor, float reach,
                 std::stop_token stop, CoverOcclusion::Ground& ground)
{
    const Eigen::Vector2f centre = box.center().head<2>();
    const float side = 2.2f * box.sizes().head<2>().maxCoeff() + 0.6f * box.sizes().z();
    ground.corner = (centre - Eigen::Vector2f::Constant(side / 2)).cast<double>();
    ground.side = side;
    ground.count = groundCount;
    for (int y = 0; y < groundCount; ++y)
        for (int x = 0; x < groundCount; ++x) {
            if (stop.stop_requested())
                return false;
            const Eigen::Vector2f share((static_cast<float>(x) + 0.5f) / groundCount,
                                        (static_cast<float>(y) + 0.5f) / groundCount);
            const Eigen::Vector2f at = ground.corner.cast<float>() + side * share;
            const Vec3f from(at.x(), at.y(), floor - 1e-3f * reach);
            ground.open.push_back(openness(rays, from, Vec3f::UnitZ(), 1.5f * reach, ground.open.size()));
        }
    smooth(ground);
    return true;
}

} // namespace

std::shared_ptr<const CoverOcclusion> CoverOcclusion::of(const Input& input, std::stop_token stop)
{
    auto result = std::make_shared<CoverOcclusion>();
    Obstacles all;
    for (const Scene::FrameLook& frame : input.frames)
        if (frame.mesh)
            all.add(*frame.mesh, frame.placement);
    if (input.surface)
        all.add(*input.surface);
    const Eigen::AlignedBox3f box = all.boundingBox();
    if (box.isEmpty())
        return result;
    const float reach = std::max(0.4f * box.diagonal().norm(), 1.f);
    if (!shadeGround(std::move(all).rays(), box, input.floor, reach, stop, result->ground))
        return nullptr;
    if (input.surface && !shadeCover(*input.surface, reach, stop, *result))
        return nullptr;
    return result;
}

} // namespace bolster
