// What a ray sees on the cover: colour from the outline coordinates, and the valley along seams.
#pragma once

#include "PreviewRenderer.h"
#include "RayScene.h"

namespace bolster {

/// What light needs to know of the place that a ray has hit. Colours are linear, 0 to 1.
struct SurfacePoint {
    Vec3f position = Vec3f::Zero();
    Vec3f normal = Vec3f::UnitZ();      ///< for shading, unit, on the side of the ray
    Vec3f face = Vec3f::UnitZ();        ///< of the triangle, unit, on the side of the ray
    Vec3f shadowOrigin = Vec3f::Zero(); ///< from where shadow rays start
    Vec3f color = Vec3f::Zero();
    float gloss = 0; ///< strength of the highlight
};

/// The size of a pixel at a hit: what one step to the right or up in the picture moves there, mm.
struct Footprint {
    Vec3f right = Vec3f::Zero();
    Vec3f up = Vec3f::Zero();
};

class CoverLook {
public:
    /// `origin` is subtracted from all positions, so that single precision is enough.
    CoverLook(const PreviewScene& scene, const Vec3& origin);

    const std::vector<Vec3f>& points() const { return m_points; }
    const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return m_triangles; }

    /// `direction` is the ray's, unit; `pixel` the steps in a plane across it.
    SurfacePoint at(const RayHit& hit, const Vec3f& direction, const Footprint& pixel) const;

private:
    struct Tone {
        Vec3f light, dark;
    };
    using SeamPart = std::array<std::uint32_t, 2>; ///< two vertices; both `none`: no part

    void takeSurface(const SurfaceMesh& mesh, const Vec3& origin);
    void takeCover(const CoverMesh& cover, const SurfaceTopology& shown, const Vec3& origin);
    void takeSeams(const std::vector<std::vector<std::uint32_t>>& seams);
    void takeLooks(const PreviewScene& scene, std::size_t trianglesPerCoarse);

    Vec3f outsideColor(const RayHit& hit, const Vec3f& direction, const Footprint& pixel) const;
    float checker(const RayHit& hit, const Vec3f& direction, const Footprint& pixel) const;
    void pressSeam(const RayHit& hit, float pixelSize, SurfacePoint& point) const;

    std::vector<Vec3f> m_points;
    std::vector<Vec3f> m_normals;
    std::vector<Eigen::Vector2f> m_pattern; ///< in checker squares
    std::vector<std::array<std::uint32_t, 3>> m_triangles;
    std::vector<std::array<SeamPart, 2>> m_seamParts; ///< per vertex, of seams through it or near it
    std::vector<std::uint16_t> m_patchOfTriangle;
    std::vector<Tone> m_tones;                ///< per patch
    std::vector<Eigen::Vector4f> m_mapColors; ///< per vertex: as displayed, and opacity; may be empty
    bool m_checker;
};

/// "#rrggbb" to linear light; something visible for anything else.
Vec3f linearColor(const std::string& color);

} // namespace bolster
