#include "PatternTransform.h"

#include <algorithm>

namespace bolster {

QPointF PatternTransform::toPixels(const Vec2& layout) const
{
    return m_origin + QPointF(m_scale * layout.x(), -m_scale * layout.y());
}

Vec2 PatternTransform::toLayout(QPointF pixel) const
{
    const QPointF p = pixel - m_origin;
    return {p.x() / m_scale, -p.y() / m_scale};
}

QTransform PatternTransform::matrix() const
{
    return {m_scale, 0, 0, -m_scale, m_origin.x(), m_origin.y()};
}

Box2 PatternTransform::visible(QSizeF size) const
{
    Box2 box;
    box.extend(toLayout({0, 0}));
    box.extend(toLayout({size.width(), size.height()}));
    return box;
}

PatternTransform PatternTransform::zoomed(QPointF pixel, double factor) const
{
    const Vec2 fixed = toLayout(pixel);
    PatternTransform result = *this;
    result.m_scale = std::clamp(m_scale * factor, smallestScale, largestScale);
    result.m_origin += pixel - result.toPixels(fixed);
    return result;
}

PatternTransform PatternTransform::panned(QPointF pixels) const
{
    PatternTransform result = *this;
    result.m_origin += pixels;
    return result;
}

PatternTransform PatternTransform::resized(QSizeF from, QSizeF to) const
{
    return panned({(to.width() - from.width()) / 2, (to.height() - from.height()) / 2});
}

PatternTransform PatternTransform::fitting(const Box2& box, QSizeF size, double margin, double largest)
{
    PatternTransform result;
    const QPointF middle(size.width() / 2, size.height() / 2);
    if (box.isEmpty()) {
        result.m_origin = middle;
        return result;
    }
    const double width = std::max(size.width() - 2 * margin, 1.0);
    const double height = std::max(size.height() - 2 * margin, 1.0);
    const Vec2 extent = box.sizes().cwiseMax(1e-6);
    result.m_scale = std::clamp(std::min(width / extent.x(), height / extent.y()), smallestScale, largest);
    result.m_origin += middle - result.toPixels(box.center());
    return result;
}

} // namespace bolster
