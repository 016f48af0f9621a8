// What a ray sees on stitches and piping: thread, or the plain colour of the pipe's fabric.
#pragma once

#include "CoverLook.h"
#include "TrimMesh.h"

namespace bolster {

class TrimLook {
public:
    /// `origin` is subtracted from all points. `trims` may be null.
    TrimLook(TrimMeshPtr trims, const Vec3& origin);

    const std::vector<Vec3f>& points() const { return m_points; }
    const std::vector<std::array<std::uint32_t, 3>>& triangles() const;

    SurfacePoint at(const RayHit& hit, const Vec3f& direction) const;

private:
    TrimMeshPtr m_trims;
    std::vector<Vec3f> m_points;
    std::vector<Vec3f> m_colors; ///< per part
};

} // namespace bolster
