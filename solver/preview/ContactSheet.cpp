#include "ContactSheet.h"

#include "Srgb.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr float textTone = 0.33f;   ///< as displayed
constexpr float paperTone = 0.965f; ///< likewise

/// How much of each pixel text covers, in the middle of a strip.
std::vector<float> textMask(const std::string& text, int width, int height, std::string& problem)
{
    std::vector<float> mask(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const int size = std::max(8, height * 5 / 9);
    for (const char* const font : {"DejaVuSans", "LiberationSans-Regular", "NotoSans-Regular", "DroidSans"}) {
        OIIO::ImageBuf strip(OIIO::ImageSpec(width, height, 1, OIIO::TypeDesc::FLOAT));
        OIIO::ImageBufAlgo::zero(strip);
        if (OIIO::ImageBufAlgo::render_text(strip, width / 2, height / 2, text, size, font, {1.f},
                                            OIIO::ImageBufAlgo::TextAlignX::Center,
                                            OIIO::ImageBufAlgo::TextAlignY::Center)) {
            strip.get_pixels(OIIO::ROI::All(), OIIO::TypeDesc::FLOAT, mask.data());
            return mask;
        }
        (void)strip.geterror();
    }
    problem = "there is no font to write names with; install DejaVu Sans";
    return mask;
}

class Sheet {
public:
    Sheet(int width, int height, bool light, bool transparent)
        : m_light(light)
    {
        m_image.width = width;
        m_image.height = height;
        const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        const auto paper = static_cast<std::uint8_t>(std::lround(255 * paperTone));
        m_image.rgba.assign(4 * pixels, transparent ? 0 : paper);
        if (light)
            m_image.light.assign(4 * pixels, transparent ? 0 : linearFromSrgb(paperTone));
        for (std::size_t at = 3; at < 4 * pixels && !transparent; at += 4) {
            m_image.rgba[at] = 255;
            if (light)
                m_image.light[at] = 1;
        }
    }

    void put(const PreviewImage& picture, int left, int top)
    {
        for (int y = 0; y < picture.height; ++y) {
            const std::size_t from = 4 * static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width);
            const auto count = 4 * static_cast<std::ptrdiff_t>(picture.width);
            std::copy_n(picture.rgba.begin() + static_cast<std::ptrdiff_t>(from), count,
                        m_image.rgba.begin() + static_cast<std::ptrdiff_t>(place(left, top + y)));
            if (m_light)
                std::copy_n(picture.light.begin() + static_cast<std::ptrdiff_t>(from), count,
                            m_image.light.begin() + static_cast<std::ptrdiff_t>(place(left, top + y)));
        }
    }

    void write(const std::vector<float>& mask, int left, int top, int width)
    {
        for (std::size_t i = 0; i < mask.size(); ++i) {
            const float share = std::clamp(mask[i], 0.f, 1.f);
            if (share <= 0)
                continue;
            const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
            const std::size_t at = place(left + x, top + y);
            const float before = static_cast<float>(m_image.rgba[at + 3]) / 255;
            const float opacity = share + (1 - share) * before;
            for (std::size_t c = at; c < at + 3; ++c) {
                const float shown = (share * textTone * 255 + (1 - share) * before * m_image.rgba[c]) / opacity;
                m_image.rgba[c] = static_cast<std::uint8_t>(std::lround(shown));
                if (m_light)
                    m_image.light[c] = share * linearFromSrgb(textTone) + (1 - share) * m_image.light[c];
            }
            m_image.rgba[at + 3] = static_cast<std::uint8_t>(std::lround(255 * opacity));
            if (m_light)
                m_image.light[at + 3] = opacity;
        }
    }

    PreviewImage finished() && { return std::move(m_image); }

private:
    std::size_t place(int x, int y) const
    {
        return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(m_image.width) +
                    static_cast<std::size_t>(x));
    }

    PreviewImage m_image;
    bool m_light;
};

} // namespace

std::array<int, 2> sheetGrid(std::size_t pictures)
{
    const int columns = std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(pictures)))));
    return {columns, (static_cast<int>(pictures) + columns - 1) / columns};
}

int sheetCaption(int width, int height)
{
    return std::max(18, std::min(width, height) / 12);
}

PreviewImage contactSheet(std::span<const SheetPicture> pictures, bool transparent, std::string& problem)
{
    if (pictures.empty())
        return {};
    const int width = pictures.front().image.width, height = pictures.front().image.height;
    const int caption = sheetCaption(width, height);
    const auto [columns, rows] = sheetGrid(pictures.size());
    const bool light = std::ranges::all_of(pictures, [](const SheetPicture& p) { return !p.image.light.empty(); });
    Sheet sheet(columns * width, rows * (height + caption), light, transparent);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const int left = static_cast<int>(i) % columns * width;
        const int top = static_cast<int>(i) / columns * (height + caption);
        sheet.put(pictures[i].image, left, top);
        sheet.write(textMask(pictures[i].name, width, caption, problem), left, top + height, width);
    }
    return std::move(sheet).finished();
}

} // namespace bolster
