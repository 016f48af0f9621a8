#include "Lettering.h"

#include "Srgb.h"

#include <algorithm>
#include <cmath>

namespace bolster {

TextMask textMask(const std::string& text, int width, int height, TextAlign align, std::string& problem)
{
    TextMask mask{width, height, {}};
    mask.share.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const TextOrder order{text, width, height, std::max(8, height * 5 / 9), align};
    for (const char* const font : {"DejaVuSans", "LiberationSans-Regular", "NotoSans-Regular", "DroidSans"})
        if (imaging().drawText(order, font, mask.share.data()))
            return mask;
    problem = "there is no font to write with; install DejaVu Sans";
    return mask;
}

void cover(PreviewImage& image, int x, int y, float share, const Tone& tone)
{
    share = std::clamp(share, 0.f, 1.f);
    if (share <= 0 || x < 0 || y < 0 || x >= image.width || y >= image.height)
        return;
    const std::size_t at =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
    const float before = static_cast<float>(image.rgba[at + 3]) / 255;
    const float opacity = share + (1 - share) * before;
    for (std::size_t c = 0; c < 3; ++c) {
        const float under = (1 - share) * before * static_cast<float>(image.rgba[at + c]);
        image.rgba[at + c] = static_cast<std::uint8_t>(std::lround((share * tone[c] * 255 + under) / opacity));
        if (!image.light.empty())
            image.light[at + c] = share * linearFromSrgb(tone[c]) + (1 - share) * image.light[at + c];
    }
    image.rgba[at + 3] = static_cast<std::uint8_t>(std::lround(255 * opacity));
    if (!image.light.empty())
        image.light[at + 3] = opacity;
}

void coverWith(PreviewImage& image, const TextMask& mask, int left, int top, const Tone& tone)
{
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            cover(image, left + x, top + y,
                  mask.share[static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) +
                             static_cast<std::size_t>(x)],
                  tone);
}

} // namespace bolster
