// What a fabric looks like, as a tile that repeats: colour, the slope of its surface, roughness.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace bolster {

/// Rows from the top of the tile down; x runs along the weft, the pattern's first coordinate, and y, up the tile,
/// along the second. Left and right border fit together, and so do top and bottom.
struct FabricMaps {
    int width = 0; ///< pixels
    int height = 0;
    double widthMm = 0; ///< of one repeat
    double heightMm = 0;
    std::vector<std::uint8_t> albedo;    ///< red, green, blue, opacity per pixel; sRGB
    std::vector<std::uint8_t> normal;    ///< 3 per pixel: x, y, z from -1 to 1 as 0 to 255, in the tile's frame
    std::vector<std::uint8_t> roughness; ///< 1 per pixel, 0 to 255; perceptual, its square is GGX's alpha
    double sheen = 0; ///< 0 to 1: light that fibres scatter where they are seen from the side (velvet)

    bool complete() const
    {
        const std::size_t pixels =
            static_cast<std::size_t>(width > 0 ? width : 0) * static_cast<std::size_t>(height > 0 ? height : 0);
        return pixels > 0 && widthMm > 0 && heightMm > 0 && albedo.size() == 4 * pixels &&
               normal.size() == 3 * pixels && roughness.size() == pixels;
    }
};

using FabricMapsPtr = std::shared_ptr<const FabricMaps>;

} // namespace bolster
