#include "TrimLook.h"

#include <algorithm>

namespace bolster {

TrimLook::TrimLook(TrimMeshPtr trims, const Vec3& origin)
    : m_trims(trims ? std::move(trims) : std::make_shared<TrimMesh>())
{
    for (const Vec3f& p : m_trims->points)
        m_points.push_back(p - origin.cast<float>());
    for (const TrimMesh::Part& part : m_trims->parts)
        m_colors.push_back(linearColor(part.color));
}

const std::vector<std::array<std::uint32_t, 3>>& TrimLook::triangles() const
{
    return m_trims->triangles;
}

SurfacePoint TrimLook::at(const RayHit& hit, const Vec3f& direction) const
{
    const auto part =
        std::ranges::upper_bound(m_trims->parts, hit.triangle, {}, &TrimMesh::Part::firstTriangle) - 1;
    const std::array<std::uint32_t, 3>& ids = m_trims->triangles[hit.triangle];
    const Eigen::Vector3f shares(1.f - hit.u - hit.v, hit.u, hit.v);
    const float side = hit.normal.dot(direction) < 0 ? 1.f : -1.f;
    SurfacePoint point;
    point.face = side * hit.normal;
    point.normal = Vec3f::Zero();
    for (std::size_t c = 0; c < 3; ++c) {
        point.normal += side * shares[static_cast<Eigen::Index>(c)] * m_trims->normals[ids[c]];
        point.position += shares[static_cast<Eigen::Index>(c)] * m_points[ids[c]];
    }
    point.normal.normalize();
    point.smooth = point.normal;
    point.shadowOrigin = point.position;
    point.color = m_colors[static_cast<std::size_t>(part - m_trims->parts.begin())];
    point.roughness = 0.6f;
    point.specular = 0.04f;
    return point;
}

} // namespace bolster
