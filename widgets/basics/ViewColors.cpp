#include "ViewColors.h"

#include <cmath>

namespace bolster {

QColor mixed(const QColor& a, const QColor& b, double share)
{
    const auto mix = [share](float x, float y) { return static_cast<float>(x + share * (y - x)); };
    return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()), mix(a.blueF(), b.blueF()),
                            mix(a.alphaF(), b.alphaF()));
}

ViewColors ViewColors::of(const QPalette& palette)
{
    ViewColors c;
    const QColor base = palette.color(QPalette::Active, QPalette::Base);
    const QColor text = palette.color(QPalette::Active, QPalette::Text);
    c.dark = base.lightness() < 128;
    c.canvas =
        c.dark ? mixed(base, palette.color(QPalette::Active, QPalette::Window), 0.35) : mixed(base, text, 0.02);
    // Of the theme with high contrast, in which nothing is set apart by shades.
    const bool strong = base == palette.color(QPalette::Active, QPalette::Window) &&
                        std::abs(base.lightness() - text.lightness()) > 250;
    c.gridMinor = mixed(c.canvas, text, c.dark ? 0.045 : 0.05);
    c.gridMajor = mixed(c.canvas, text, c.dark ? 0.10 : 0.11);
    c.outline = mixed(c.canvas, text, 0.82);
    c.label = mixed(c.canvas, text, 0.92);
    c.mutedLabel = mixed(c.canvas, text, 0.68);
    c.mesh = mixed(c.canvas, text, 0.5);
    c.mesh.setAlphaF(0.45F);
    c.accent = palette.color(QPalette::Active, QPalette::Highlight);
    c.hover = mixed(c.accent, c.canvas, 0.15);
    c.fixation = c.dark ? QColor(0xc9, 0xce, 0xd6) : QColor(0x4a, 0x50, 0x5c);
    c.handle = c.dark ? QColor(0xff, 0x9a, 0x3c) : QColor(0xb8, 0x5a, 0x00);
    c.fancySeam = c.dark ? QColor(0xe0, 0x8a, 0xd4) : QColor(0xa3, 0x3a, 0x95);
    c.snap = c.dark ? QColor(0x3d, 0xd0, 0xb8) : QColor(0x00, 0x8a, 0x7a);
    c.pointFill = c.dark ? mixed(c.canvas, QColor(Qt::black), 0.3) : QColor(Qt::white);
    c.error = c.dark ? QColor(0xff, 0x6b, 0x5e) : QColor(0xc6, 0x28, 0x1c);
    c.warning = c.dark ? QColor(0xf0, 0xa8, 0x30) : QColor(0x94, 0x60, 0x00);
    if (strong) {
        c.canvas = base;
        c.gridMinor = mixed(c.canvas, text, 0.12);
        c.gridMajor = mixed(c.canvas, text, 0.3);
        c.outline = c.label = c.fixation = text;
        c.mutedLabel = mixed(c.canvas, text, 0.8);
    }
    return c;
}

QColor ViewColors::patchFill(const QColor& fabric, double strength) const
{
    return mixed(canvas, fabric, dark ? strength * 1.35 : strength);
}

} // namespace bolster
