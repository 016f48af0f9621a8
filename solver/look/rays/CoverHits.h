// What a ray sees on the cover: colour from the outline coordinates, and the relief of seams.
#pragma once

#include "FabricSampler.h"
#include "HitFrame.h"
#include "PreviewRenderer.h"
#include "SeamRelief.h"
#include "Shading.h"

namespace bolster {

/// What light needs to know of the place that a ray has hit. Colours are linear, 0 to 1.
struct ShadedPoint {
    Vec3f position = Vec3f::Zero();
    Vec3f normal = Vec3f::UnitZ();      ///< for shading, unit, on the side of the ray
    Vec3f smooth = Vec3f::UnitZ();      ///< without the fabric's relief: where light may come from
    Vec3f face = Vec3f::UnitZ();        ///< of the triangle, unit, on the side of the ray
    Vec3f shadowOrigin = Vec3f::Zero(); ///< from where shadow rays start
    Vec3f color = Vec3f::Zero();
    float roughness = 1; ///< perceptual: its square is GGX's alpha
    float sheen = 0;     ///< of fibres, 0 to 1
    float specular = 0;  ///< share of light that is reflected straight on; 0.04 for leather and lacquer

    /// What the surface is like there.
    shading::Cloth cloth() const;
    void take(const shading::Cloth& cloth);
    /// Takes the look of a fabric; its relief leans the normal on demand. `toTile` turns the cloth's frame into
    /// that of the maps, `behind` is seen through holes.
    void wear(const FabricSampler& maps, const ClothFrame& cloth, const Eigen::Matrix2f& toTile,
              const Vec3f& behind, bool relief);
};

class CoverHits {
public:
    /// `origin` is subtracted from all positions, so that single precision is enough.
    CoverHits(const Scene& scene, const Vec3& origin);

    const std::vector<Vec3f>& points() const { return m_points; }
    const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return m_triangles; }

    /// `direction` is the ray's, unit; `pixel` the steps in a plane across it.
    ShadedPoint at(const RayHit& hit, const Vec3f& direction, const Footprint& pixel) const;

private:
    struct Cloth {
        Vec3f light = Vec3f::Zero(), dark = Vec3f::Zero(); ///< without maps: of the checker
        std::shared_ptr<const FabricSampler> maps = nullptr;
        float sheen = 0;
        Eigen::Matrix2f toTile = Eigen::Matrix2f::Identity(); ///< turns the outline's frame into the maps'
    };
    void takeSurface(const SurfaceMesh& mesh, const Vec3& origin);
    void takeCover(const CoverMesh& cover, const SurfaceTopology& shown, const Vec3& origin);
    void takeLooks(const Scene& scene, std::size_t trianglesPerCoarse);

    void dress(const RayHit& hit, const std::optional<ClothFrame>& pattern, ShadedPoint& point) const;
    float checker(const ClothFrame& pattern) const;
    void pressSeam(const RayHit& hit, const TriangleFrame& triangle, ShadedPoint& point) const;

    std::vector<Vec3f> m_points;
    std::vector<Vec3f> m_normals;
    std::vector<Eigen::Vector2f> m_pattern; ///< mm
    std::vector<std::array<std::uint32_t, 3>> m_triangles;
    SeamReliefPtr m_relief;
    std::vector<std::uint16_t> m_patchOfTriangle;
    std::vector<Cloth> m_cloths;              ///< per patch
    std::vector<Eigen::Vector4f> m_mapColors; ///< per vertex: as displayed, and opacity; may be empty
    bool m_checker;
    float m_checkerSize; ///< mm
};

} // namespace bolster
