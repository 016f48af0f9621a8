#include "PatternArrows.h"

#include "ArcLength.h"
#include "ViewColors.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace bolster {

namespace {

constexpr double leastWay = 0.05;    // mm: less than anybody can cut
constexpr double headLength = 7;     // pixels
constexpr double headSlope = 0.4;    // half of its width
constexpr double shownOutline = 1.2; // pixels
constexpr std::array factors{1.0, 2.0, 5.0, 10.0, 20.0, 50.0};

} // namespace

PatternArrows arrowsBetween(const Design& before, const Design& after, double apart, double longest,
                            std::optional<double> longer)
{
    PatternArrows result;
    double most = 0;
    before.each<Patch>([&](ElementId id, const Patch& old) {
        const auto* now = after.find<Patch>(id);
        if (!now || now->outline == old.outline || now->outline.knots() != old.outline.knots())
            return;
        const ArcLength2 length(old.outline);
        const int count = std::max(8, static_cast<int>(length.total() / apart));
        for (int k = 0; k < count; ++k) {
            const double at = length.parameterAt(length.total() * k / count);
            const Vec2 from = toLayout(old, old.outline.at(at)), to = toLayout(old, now->outline.at(at));
            if ((to - from).norm() < leastWay)
                continue;
            most = std::max(most, (to - from).norm());
            result.arrows.push_back({from, to});
        }
    });
    for (const double factor : factors)
        if (factor * most <= longest)
            result.longer = factor;
    if (longer)
        result.longer = *longer;
    for (PatternArrow& arrow : result.arrows)
        arrow.to = arrow.from + result.longer * (arrow.to - arrow.from);
    return result;
}

void paintArrows(QPainter& painter, const PatternArrows& arrows, const PatternTransform& transform,
                 const ViewColors& colors)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colors.snap, shownOutline));
    painter.setBrush(colors.snap);
    for (const PatternArrow& arrow : arrows.arrows) {
        const QPointF from = transform.toPixels(arrow.from), to = transform.toPixels(arrow.to);
        const QPointF way = to - from;
        const double length = std::hypot(way.x(), way.y());
        if (length < 1)
            continue;
        painter.drawLine(from, to);
        const QPointF along = way / length * std::min(headLength, length), side(-along.y(), along.x());
        const QPointF back = to - along;
        painter.drawPolygon(QPolygonF{to, back + headSlope * side, back - headSlope * side});
    }
    painter.restore();
}

} // namespace bolster
