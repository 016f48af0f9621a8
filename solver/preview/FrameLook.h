// What a ray sees on a frame: smooth grey plastic.
#pragma once

#include "CoverLook.h"

namespace bolster {

class FrameLook {
public:
    /// `origin` is subtracted from all points.
    FrameLook(const PreviewScene::FrameLook& frame, const Vec3& origin);

    const std::vector<Vec3f>& points() const { return m_points; }
    const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return m_triangles; }

    SurfacePoint at(const RayHit& hit, const Vec3f& direction) const;

private:
    std::vector<Vec3f> m_points;
    std::vector<std::array<std::uint32_t, 3>> m_triangles;
    std::vector<std::array<Vec3f, 3>> m_normals; ///< per corner of each triangle
};

/// The placed points of a frame's mesh, mm.
std::vector<Vec3> placedPoints(const PreviewScene::FrameLook& frame);

} // namespace bolster
