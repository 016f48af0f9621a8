#include "PictureLegend.h"

#include "Lettering.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr int leastSide = 160; ///< pixels of the picture
constexpr float paper = 0.985f;
constexpr float paperShare = 0.82f;
constexpr float ink = 0.2f;

Tone toneOf(const MapScale::Rgba& color)
{
    return {static_cast<float>(color[0]) / 255, static_cast<float>(color[1]) / 255,
            static_cast<float>(color[2]) / 255};
}

/// Lines of one height from the top to the bottom of a sheet of paper.
class Legend {
public:
    Legend(PreviewImage& image, const PictureLegend& legend, std::string& problem)
        : m_image(image)
        , m_legend(legend)
        , m_problem(problem)
        , m_line(std::max(11, std::min(image.width, image.height) / 34))
        , m_width(std::min(14 * m_line, image.width - 4 * m_line))
        , m_left(3 * m_line / 2)
        , m_top(image.height - (legend.over.empty() ? 5 : 6) * m_line)
    {}

    void draw()
    {
        const int pad = m_line / 2;
        fill(m_left - pad, m_top - pad / 2, m_width + 2 * pad, (m_legend.over.empty() ? 3 : 4) * m_line + pad,
             paperShare, greyTone(paper));
        text(m_legend.title, m_top, TextAlign::Left);
        bar(m_top + m_line + m_line / 8, 3 * m_line / 4);
        const int numbers = m_top + 2 * m_line;
        text(m_legend.lowest, numbers, TextAlign::Left);
        if (m_legend.scale.kind == MapScale::Kind::Diverging)
            text(m_legend.middle, numbers, TextAlign::Center);
        text(m_legend.highest, numbers, TextAlign::Right);
        if (m_legend.over.empty())
            return;
        const int last = m_top + 3 * m_line, square = m_line * 5 / 8;
        int left = m_left;
        if (m_legend.scale.kind == MapScale::Kind::Diverging) {
            fill(left, last + (m_line - square) / 2, square, square, 1, toneOf(MapScale::under));
            left += 5 * square / 4;
        }
        fill(left, last + (m_line - square) / 2, square, square, 1, toneOf(MapScale::over));
        left += 3 * square / 2;
        const TextMask over = textMask(m_legend.over, m_left + m_width - left, m_line, TextAlign::Left, m_problem);
        coverWith(m_image, over, left, last, greyTone(ink));
    }

private:
    void fill(int left, int top, int width, int height, float share, const Tone& tone)
    {
        for (int y = top; y < top + height; ++y)
            for (int x = left; x < left + width; ++x)
                cover(m_image, x, y, share, tone);
    }

    void text(const std::string& words, int top, TextAlign align)
    {
        coverWith(m_image, textMask(words, m_width, m_line, align, m_problem), m_left, top, greyTone(ink));
    }

    void bar(int top, int height)
    {
        const MapScale& scale = m_legend.scale;
        for (int x = 0; x < m_width; ++x) {
            const float share = (static_cast<float>(x) + 0.5f) / static_cast<float>(m_width);
            const float at = scale.kind == MapScale::Kind::Diverging ? 2 * share - 1 : share;
            fill(m_left + x, top, 1, height, 1, toneOf(scale.color(scale.limit * at)));
        }
    }

    PreviewImage& m_image;
    const PictureLegend& m_legend;
    std::string& m_problem;
    int m_line; ///< pixels
    int m_width;
    int m_left;
    int m_top;
};

} // namespace

void drawLegend(PreviewImage& image, const PictureLegend& legend, std::string& problem)
{
    if (!image.empty() && std::min(image.width, image.height) >= leastSide)
        Legend(image, legend, problem).draw();
}

} // namespace bolster
