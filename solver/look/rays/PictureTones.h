// How light becomes what a screen shows.
#pragma once

#include "RayScene.h"

#include <array>
#include <cstdint>
#include <string>

namespace bolster {

/// 0 to 63 within a block of 8 x 8 pixels, such that pixels close together are far apart in the order
/// (the ordered dither matrix: bits of x ^ y and y, interleaved and reversed).
int orderInBlock(int x, int y);

struct PixelLight {
    Vec3f color = Vec3f::Zero(); ///< linear, times the opacity
    float opacity = 1;
};

/// The light that is displayed, 0 to 1 in sRGB and not times the opacity. Highlights are bent into what a screen
/// can show, so that they keep their shape; black that is seen through darkens as much on a screen as its light
/// would.
std::array<float, 4> displayedShares(const PixelLight& light);
/// The same as bytes, with the steps of gradients hidden.
std::array<std::uint8_t, 4> displayed(const PixelLight& light, int x, int y);

/// The light that is displayed in this colour, "#rrggbb".
Vec3f lightDisplayedAs(const std::string& color);

} // namespace bolster
