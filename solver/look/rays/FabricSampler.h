// A fabric's maps as light needs them: linear, and filtered for pixels of any size.
#pragma once

#include "FabricMaps.h"
#include "RayScene.h"

namespace bolster {

/// Mip-maps of our own, in memory, rather than OpenImageIO's TextureSystem: that one reads files, which baked maps
/// never are, and blurs normals without telling how much they differed. Here what mip-maps blur becomes roughness:
/// far away leather shines as its grain makes it shine.
class FabricSampler {
public:
    /// `maps` must be complete.
    explicit FabricSampler(const FabricMaps& maps);

    struct Sample {
        Vec3f color = Vec3f::Zero(); ///< linear, times its opacity
        float opacity = 1;
        Eigen::Vector2f lean = Eigen::Vector2f::Zero(); ///< of the normal (x, y, 1) in the tile's frame, y up
        float roughness = 1;                            ///< perceptual, with that of what is smaller than the pixel
    };

    /// At a place in the tile's frame, mm, for a pixel with these sides (mm): trilinear, up to eight times along
    /// the longer side.
    Sample at(const Eigen::Vector2f& place, const Eigen::Vector2f& right, const Eigen::Vector2f& up) const;

private:
    /// Numbers that may be averaged: colour and opacity, lean, its mean square, alpha^2.
    using Numbers = Eigen::Array<float, 8, 1>;
    struct Level {
        int width = 0, height = 0;
        std::vector<std::array<std::uint16_t, 8>> texels; ///< rows from the bottom up
    };

    static Level finest(const FabricMaps& maps);
    static Level half(const Level& finer);
    static Numbers bilinear(const Level& level, const Eigen::Vector2f& share);
    Numbers trilinear(float level, const Eigen::Vector2f& share) const;

    std::vector<Level> m_levels;
    Eigen::Vector2f m_size;        ///< of the tile, mm
    Eigen::Vector2f m_texelsPerMm; ///< of the finest level
};

} // namespace bolster
