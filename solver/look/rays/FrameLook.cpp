#include "FrameLook.h"

#include <cmath>

namespace bolster {

namespace {

float smoothly(float from, float to, float x)
{
    const float t = std::clamp((x - from) / (to - from), 0.f, 1.f);
    return t * t * (3 - 2 * t);
}

/// How much darker wood is at a place of its grain, mm: rings around a wavy axis beside the piece, late wood ending
/// sharply. The same as in frame.frag.
float woodTone(const Vec3f& at)
{
    const float wave = 6 * std::sin(at.z() / 180 + 0.7f) + 2.5f * std::sin(at.z() / 47 + at.x() / 31);
    const float ring = std::hypot(at.x() + 55 + wave, 0.6f * at.y() + 18 + 0.5f * wave) / 7;
    const float share = ring - std::floor(ring);
    const float late = smoothly(0.35f, 0.95f, share) * (1 - smoothly(0.95f, 1, share));
    const float fibre = std::sin(2.1f * at.x() + 3 * std::sin(at.z() / 23)) * std::sin(2.6f * at.y() + at.z() / 17);
    return 0.34f * late + 0.05f * fibre;
}

} // namespace

FrameLook::FrameLook(const Scene::FrameLook& frame, const Vec3& origin)
    : m_skin(frame.skin)
    , m_kind(frame.material.kind)
    , m_color(linearColor(colorShown(frame.material)))
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

SurfacePoint FrameLook::at(const RayHit& hit, const Vec3f& direction) const
{
    const float side = hit.normal.dot(direction) < 0 ? 1.f : -1.f;
    const FrameSkin::Corner* corners = &m_skin->corners[m_triangles[hit.triangle][0]];
    const std::array<float, 3> weights{1.f - hit.u - hit.v, hit.u, hit.v};
    Vec3f normal = Vec3f::Zero(), grain = Vec3f::Zero();
    SurfacePoint point;
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
    point.color = m_color;
    point.roughness = 0.5f;
    point.specular = 0.04f;
    switch (m_kind) {
    case FrameMaterial::Kind::Plain:
        break;
    case FrameMaterial::Kind::Wood:
        point.color *= 1 - woodTone(grain);
        point.roughness = 0.42f;
        break;
    case FrameMaterial::Kind::Metal:
        point.color *= 0.35f;
        point.roughness = 0.3f;
        point.specular = 0.55f;
        break;
    case FrameMaterial::Kind::Plastic:
        point.roughness = 0.36f;
        break;
    case FrameMaterial::Kind::Foam:
        point.roughness = 1;
        point.sheen = 0.25f;
        point.specular = 0.02f;
        break;
    }
    return point;
}

} // namespace bolster
