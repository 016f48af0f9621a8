#include "TrimHits.h"

#include "LinearLight.h"
#include "Shading.h"

#include <algorithm>

namespace bolster {

TrimHits::TrimHits(TrimMeshPtr trims, const std::map<ElementId, FabricMapsPtr>& fabrics, const Vec3& origin)
    : m_trims(trims ? std::move(trims) : std::make_shared<TrimMesh>())
{
    for (const Vec3f& p : m_trims->points)
        m_points.push_back(p - origin.cast<float>());
    std::map<ElementId, std::shared_ptr<const FabricSampler>> samplers;
    for (const TrimMesh::Part& part : m_trims->parts) {
        m_colors.push_back(lightOf(part.color));
        const auto maps = fabrics.find(part.fabric);
        const bool textured = maps != fabrics.end() && maps->second && maps->second->complete();
        if (textured && !samplers[part.fabric])
            samplers[part.fabric] = std::make_shared<FabricSampler>(*maps->second);
        m_maps.push_back(textured ? samplers[part.fabric] : nullptr);
        m_sheens.push_back(textured ? static_cast<float>(maps->second->sheen) : 0);
    }
}

const std::vector<std::array<std::uint32_t, 3>>& TrimHits::triangles() const
{
    return m_trims->triangles;
}

ShadedPoint TrimHits::at(const RayHit& hit, const Vec3f& direction, const Footprint& pixel) const
{
    const auto part = static_cast<std::size_t>(
        std::ranges::upper_bound(m_trims->parts, hit.triangle, {}, &TrimMesh::Part::firstTriangle) -
        m_trims->parts.begin() - 1);
    const std::array<std::uint32_t, 3>& ids = m_trims->triangles[hit.triangle];
    const Eigen::Vector3f shares(1.f - hit.u - hit.v, hit.u, hit.v);
    const float side = hit.normal.dot(direction) < 0 ? 1.f : -1.f;
    ShadedPoint point;
    point.face = side * hit.normal;
    point.normal = Vec3f::Zero();
    for (std::size_t c = 0; c < 3; ++c) {
        point.normal += side * shares[static_cast<Eigen::Index>(c)] * m_trims->normals[ids[c]];
        point.position += shares[static_cast<Eigen::Index>(c)] * m_points[ids[c]];
    }
    point.normal.normalize();
    point.smooth = point.normal;
    point.shadowOrigin = point.position;
    point.color = m_colors[part];
    point.roughness = shading::trimRoughness;
    point.specular = shading::clothSpecular;
    point.sheen = m_sheens[part];
    if (!m_maps[part])
        return point;
    const std::vector<Eigen::Vector2f>& cloth = m_trims->cloth;
    const auto triangle =
        TriangleFrame::of({m_points[ids[0]], m_points[ids[1]], m_points[ids[2]]}, hit, direction, pixel);
    const auto frame =
        triangle ? ClothFrame::of(*triangle, {cloth[ids[0]], cloth[ids[1]], cloth[ids[2]]}, hit) : std::nullopt;
    if (frame)
        point.wear(*m_maps[part], *frame, Eigen::Matrix2f::Identity(), point.color, side > 0);
    return point;
}

} // namespace bolster
