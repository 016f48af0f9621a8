// Which pictures are read, told by their first bytes and never by their names.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace bolster {

enum class ImageKind { Png, Jpeg, Tiff, Exr };

/// As the file itself says; nothing for any other kind. The first 8 bytes are enough.
std::optional<ImageKind> imageKindOf(std::string_view firstBytes);

/// Whether a JPEG file goes on to its end mark: the decoder would fill up what is missing with grey.
bool jpegIsWhole(std::string_view bytes);

inline constexpr std::uint64_t mostImagePixels = 64ull << 20; ///< 8192 x 8192
inline constexpr std::uint32_t longestImageSide = 1u << 20;   ///< pixels

/// Whether a picture of that size may be read.
constexpr bool imageFits(std::uint64_t width, std::uint64_t height)
{
    return width > 0 && height > 0 && width <= longestImageSide && height <= longestImageSide &&
           width * height <= mostImagePixels;
}

} // namespace bolster
