// What a ray sees on stitches and piping: thread, or the pipe's fabric.
#pragma once

#include "CoverHits.h"
#include "TrimMesh.h"

namespace bolster {

class TrimHits {
public:
    /// `origin` is subtracted from all points. `trims` may be null; fabrics without maps are plain.
    TrimHits(TrimMeshPtr trims, const std::map<ElementId, FabricMapsPtr>& fabrics, const Vec3& origin);

    const std::vector<Vec3f>& points() const { return m_points; }
    const std::vector<std::array<std::uint32_t, 3>>& triangles() const;

    ShadedPoint at(const RayHit& hit, const Vec3f& direction, const Footprint& pixel) const;

private:
    TrimMeshPtr m_trims;
    std::vector<Vec3f> m_points;
    std::vector<Vec3f> m_colors;                              ///< per part
    std::vector<std::shared_ptr<const FabricSampler>> m_maps; ///< per part; null: plain
    std::vector<float> m_sheens;                              ///< per part
};

} // namespace bolster
