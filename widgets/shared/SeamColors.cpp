#include "SeamColors.h"

#include <algorithm>
#include <array>
#include <set>

namespace bolster {

namespace {

struct Shade {
    QRgb onLight;
    QRgb onDark;
};

// Hues that stay apart for the common kinds of colour blindness, lightness alternating; red is kept for errors.
constexpr std::array<Shade, 8> palette{{
    {0xff0072b2, 0xff4aa8e8}, // blue
    {0xffc47200, 0xffffb347}, // orange
    {0xff009e73, 0xff2fcf9f}, // bluish green
    {0xffcc5fa0, 0xffec8fc6}, // reddish purple
    {0xff1b8cc0, 0xff8fd6ff}, // sky blue
    {0xff8c8900, 0xffe6df5a}, // yellow
    {0xff6a3d9a, 0xffb79bea}, // violet
    {0xff5b7f1a, 0xffa9cf63}, // olive green
}};

} // namespace

std::map<ElementId, QColor> seamColors(const Design& design, bool darkBackground)
{
    std::map<ElementId, QColor> colors;
    std::map<ElementId, std::set<std::size_t>> usedAt;
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        const std::set<std::size_t>& a = usedAt[seam.a.patch];
        const std::set<std::size_t>& b = usedAt[seam.b.patch];
        // By the id, so that other seams coming and going rarely change it; the next one that neither patch has.
        const std::size_t first = static_cast<std::size_t>(number(id)) % palette.size();
        std::size_t best = first;
        for (std::size_t i = 0; i < palette.size(); ++i)
            if (const std::size_t next = (first + i) % palette.size(); !a.contains(next) && !b.contains(next)) {
                best = next;
                break;
            }
        usedAt[seam.a.patch].insert(best);
        usedAt[seam.b.patch].insert(best);
        colors[id] = QColor(darkBackground ? palette[best].onDark : palette[best].onLight);
    });
    return colors;
}

QString seamLabel(std::size_t before)
{
    QString label;
    for (std::size_t rest = before + 1; rest > 0; rest = (rest - 1) / 26)
        label.prepend(QChar(u'A' + static_cast<char16_t>((rest - 1) % 26)));
    return label;
}

QString seamLetter(const Design& design, ElementId seam)
{
    if (!design.find<Seam>(seam))
        return {};
    std::size_t before = 0;
    design.each<Seam>([&](ElementId id, const Seam&) { before += id < seam ? 1 : 0; });
    return seamLabel(before);
}

} // namespace bolster
