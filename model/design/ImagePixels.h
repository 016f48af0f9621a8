// A picture in memory, decoded.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace bolster {

/// Rows from the top, pixels from the left, each red, green, blue, opacity: 8 bits, sRGB, not premultiplied.
struct ImagePixels {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba; ///< width x height x 4

    bool complete() const
    {
        return width > 0 && height > 0 &&
               rgba.size() == 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }

    friend bool operator==(const ImagePixels&, const ImagePixels&) = default;
};

using ImagePixelsPtr = std::shared_ptr<const ImagePixels>;

} // namespace bolster
