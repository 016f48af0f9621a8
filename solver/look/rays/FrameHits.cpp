#include "FrameHits.h"

#include "LinearLight.h"

namespace bolster {

FrameHits::FrameHits(const Scene::FrameLook& frame, const Vec3& origin)
    : m_skin(frame.skin)
    , m_kind(frame.material.kind)
    , m_color(lightOf(colorShown(frame.material)))
    , m_opacity(static_cast<float>(frame.opacity))
{
    if (frame.mesh && !(m_skin && m_skin->placement == frame.placement))
        m_skin = FrameSkins(nullptr).skin(*frame.mesh, frame.placement);
    if (!m_skin)
        return;
    const Vec3f shift = origin.cast<float>();
    for (const FrameSkin::Corner& corner : m_skin->corners)
        m_points.emplace_back(corner.position - shift);
    for (std::uint32_t i = 0; i + 2 < m_points.size(); i += 3)
        m_triangles.push_back({i, i + 1, i + 2});
}

ShadedPoint FrameHits::at(const RayHit& hit, const Vec3f& direction) const
{
    const float side = hit.normal.dot(direction) < 0 ? 1.f : -1.f;
    const FrameSkin::Corner* corners = &m_skin->corners[m_triangles[hit.triangle][0]];
    const std::array<float, 3> weights{1.f - hit.u - hit.v, hit.u, hit.v};
    Vec3f normal = Vec3f::Zero(), grain = Vec3f::Zero();
    ShadedPoint point;
    for (std::size_t i = 0; i < 3; ++i) {
        normal += weights[i] * corners[i].normal;
        grain += weights[i] * corners[i].grain;
        point.position += weights[i] * m_points[m_triangles[hit.triangle][i]];
    }
    point.face = side * hit.normal;
    point.normal = normal.squaredNorm() > 1e-6f ? Vec3f(side * normal.normalized()) : point.face;
    if (point.normal.dot(point.face) < 0) // a file that turns its normals away
        point.normal = -point.normal;
    point.smooth = point.normal;
    point.shadowOrigin = point.position;
    const bool wood = m_kind == FrameMaterial::Kind::Wood;
    const float dark = wood ? shading::woodTone(shading::woodRings(grain.x(), grain.y(), grain.z()), grain.x(),
                                                grain.y(), grain.z())
                            : 0.f;
    point.take(shading::frameSurface(static_cast<int>(m_kind), m_color.array(), dark));
    return point;
}

} // namespace bolster
