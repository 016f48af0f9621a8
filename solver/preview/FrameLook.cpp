#include "FrameLook.h"

#include "MeshShape.h"

namespace bolster {

std::vector<Vec3> placedPoints(const PreviewScene::FrameLook& frame)
{
    std::vector<Vec3> points;
    if (frame.mesh)
        for (const Vec3& p : frame.mesh->points)
            points.push_back(frame.rotation * (frame.scale * p) + frame.position);
    return points;
}

FrameLook::FrameLook(const PreviewScene::FrameLook& frame, const Vec3& origin)
{
    if (!frame.mesh)
        return;
    m_triangles = frame.mesh->triangles;
    const std::vector<Vec3> points = placedPoints(frame);
    m_normals = cornerNormals(points, m_triangles);
    for (const Vec3& p : points)
        m_points.push_back((p - origin).cast<float>());
}

SurfacePoint FrameLook::at(const RayHit& hit, const Vec3f& direction) const
{
    const float side = hit.normal.dot(direction) < 0 ? 1.f : -1.f;
    const std::array<std::uint32_t, 3>& ids = m_triangles[hit.triangle];
    const std::array<Vec3f, 3>& normals = m_normals[hit.triangle];
    SurfacePoint point;
    point.face = side * hit.normal;
    point.normal =
        side * ((1.f - hit.u - hit.v) * normals[0] + hit.u * normals[1] + hit.v * normals[2]).normalized();
    point.smooth = point.normal;
    point.position = (1.f - hit.u - hit.v) * m_points[ids[0]] + hit.u * m_points[ids[1]] + hit.v * m_points[ids[2]];
    point.shadowOrigin = point.position;
    point.color = Vec3f(0.42f, 0.43f, 0.45f);
    point.roughness = 0.5f;
    point.specular = 0.04f;
    return point;
}

} // namespace bolster
