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

/// Pictures are scaled down to this while they are decoded: the maps of fabrics use half as many.
inline constexpr std::uint32_t mostDecodedSide = 2048; ///< pixels

/// How many pixels of each side become one.
constexpr std::uint32_t shrinkingOf(std::uint32_t width, std::uint32_t height)
{
    const std::uint32_t longer = width > height ? width : height;
    return longer == 0 ? 1 : (longer - 1) / mostDecodedSide + 1;
}

} // namespace bolster
