#include "ContactSheet.h"

#include "Lettering.h"
#include "Srgb.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr float textTone = 0.33f;   ///< as displayed
constexpr float paperTone = 0.965f; ///< likewise

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

    void write(const TextMask& mask, int left, int top) { coverWith(m_image, mask, left, top, greyTone(textTone)); }

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
        sheet.write(textMask(pictures[i].name, width, caption, TextAlign::Center, problem), left, top + height);
    }
    return std::move(sheet).finished();
}

} // namespace bolster
