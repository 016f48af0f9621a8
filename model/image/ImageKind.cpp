#include "ImageKind.h"

#include <utility>

namespace bolster {

using namespace std::string_view_literals;

std::optional<ImageKind> imageKindOf(std::string_view firstBytes)
{
    constexpr std::pair<std::string_view, ImageKind> marks[] = {{"\x89PNG\r\n\x1a\n"sv, ImageKind::Png},
                                                                {"\xff\xd8\xff"sv, ImageKind::Jpeg},
                                                                {"II*\0"sv, ImageKind::Tiff},
                                                                {"MM\0*"sv, ImageKind::Tiff},
                                                                {"II+\0"sv, ImageKind::Tiff}, // beyond 4 GB
                                                                {"MM\0+"sv, ImageKind::Tiff},
                                                                {"\x76\x2f\x31\x01"sv, ImageKind::Exr}};
    for (const auto& [mark, kind] : marks)
        if (firstBytes.starts_with(mark))
            return kind;
    return std::nullopt;
}

bool jpegIsWhole(std::string_view bytes)
{
    constexpr int startOfScan = 0xDA, endOfImage = 0xD9;
    std::size_t at = 2;
    while (bytes.size() >= 4 && at < bytes.size() - 3) {
        const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[at + i]); };
        if (byte(0) != 0xFF || byte(1) == 0xFF) { // coded pixels, and bytes that fill up
            ++at;
            continue;
        }
        const int marker = byte(1);
        if (marker == endOfImage)
            return true;
        const bool alone = marker == 0 || marker == 1 || (marker >= 0xD0 && marker <= 0xD8);
        const std::size_t length = alone ? 0 : static_cast<std::size_t>(byte(2)) << 8 | byte(3);
        at += 2 + (marker == startOfScan ? 0 : length);
    }
    return bytes.ends_with("\xff\xd9");
}

} // namespace bolster
