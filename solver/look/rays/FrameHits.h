// What a ray sees on a frame: wood, metal, plastic or foam.
#pragma once

#include "CoverHits.h"

namespace bolster {

class FrameHits {
public:
    /// `origin` is subtracted from all points.
    FrameHits(const Scene::FrameLook& frame, const Vec3& origin);

    const std::vector<Vec3f>& points() const { return m_points; }
    const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return m_triangles; }
    float opacity() const { return m_opacity; }

    ShadedPoint at(const RayHit& hit, const Vec3f& direction) const;

private:
    FrameSkinPtr m_skin;
    std::vector<Vec3f> m_points;
    std::vector<std::array<std::uint32_t, 3>> m_triangles; ///< three corners each
    FrameMaterial::Kind m_kind;
    Vec3f m_color; ///< linear
    float m_opacity;
};

} // namespace bolster
