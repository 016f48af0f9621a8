// A part of a picture while it is drawn: light and shadow apart, so that the shadows can be smoothed.
#pragma once

#include "RayScene.h"

#include <limits>
#include <vector>

namespace bolster {

/// Means over the samples of a pixel.
struct PicturePixel {
    Vec3f constant = Vec3f::Zero(); ///< light that no shadow touches
    Vec3f direct = Vec3f::Zero();   ///< from the key light, if nothing stands between
    Vec3f ambient = Vec3f::Zero();  ///< from all around, likewise
    /// Of a transparent picture: the part of what is behind that shows through, whatever the shadow, where the key
    /// light falls, and where light from all around does.
    Vec3f through = Vec3f::Zero();
    float keySeen = 0, keyAsked = 0; ///< rays to the key light
    float skySeen = 0, skyAsked = 0; ///< rays to the sky
    Vec3f position = Vec3f::Zero();
    Vec3f normal = Vec3f::Zero();
    float depth = std::numeric_limits<float>::infinity();
};

/// A rectangle of pixels with a margin, which its neighbours draw again: every tile is a world of its own.
class PictureTile {
public:
    static constexpr int size = 64;
    static constexpr int margin = 4;

    PictureTile(int x, int y, int pictureWidth, int pictureHeight);

    int left() const { return m_left; }
    int top() const { return m_top; }
    int right() const { return m_left + m_width; }
    int bottom() const { return m_top + m_height; }
    PicturePixel& at(int x, int y) { return m_pixels[index(x, y)]; }
    const PicturePixel& at(int x, int y) const { return m_pixels[index(x, y)]; }

    /// The pixel's linear light, with the share of light that arrives averaged over neighbours on the same
    /// smooth surface. `pixelSize` is mm per pixel there. The fourth number is what shows through: `through`, lit.
    Eigen::Vector4f resolved(int x, int y, float pixelSize) const;
    /// The same without shadows.
    Eigen::Vector4f unshadowed(int x, int y) const { return lit(at(x, y), 1, 1); }

private:
    static Eigen::Vector4f lit(const PicturePixel& pixel, float key, float sky);
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y - m_top) * m_width + static_cast<std::size_t>(x - m_left);
    }

    int m_left, m_top, m_width, m_height;
    std::vector<PicturePixel> m_pixels;
};

} // namespace bolster
