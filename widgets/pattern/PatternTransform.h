// Layout millimetres (y up) to widget pixels (y down) and back.
#pragma once

#include "Geometry.h"

#include <QPointF>
#include <QSizeF>
#include <QTransform>

namespace bolster {

/// A value: which part of the layout a widget shows.
class PatternTransform {
public:
    static constexpr double smallestScale = 0.002; ///< pixels per mm
    static constexpr double largestScale = 200;

    double scale() const { return m_scale; } ///< pixels per mm
    double millimetres(double pixels) const { return pixels / m_scale; }

    QPointF toPixels(const Vec2& layout) const;
    Vec2 toLayout(QPointF pixel) const;
    QTransform matrix() const; ///< of QPointF(x, y) in layout mm
    Box2 visible(QSizeF size) const;

    /// The layout point under `pixel` stays there. The scale is clamped.
    PatternTransform zoomed(QPointF pixel, double factor) const;
    PatternTransform panned(QPointF pixels) const;
    /// The layout point in the middle of the widget stays in the middle.
    PatternTransform resized(QSizeF from, QSizeF to) const;
    /// Shows the whole box with `margin` pixels around it, at most at `largest` pixels per mm. Default for an empty
    /// box.
    static PatternTransform fitting(const Box2& box, QSizeF size, double margin, double largest = 4);

private:
    double m_scale = 0.5;
    QPointF m_origin; ///< where the layout's origin is, pixels
};

} // namespace bolster
