#include "PatternGrid.h"

#include "Units.h"

#include <QLineF>
#include <QPainter>
#include <QSize>
#include <QVector>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

/// Vertical and horizontal lines every `step` mm, on whole pixels so that they are crisp.
QVector<QLineF> gridLines(const PatternTransform& transform, const QSize& size, double step)
{
    const Box2 box = transform.visible(size);
    QVector<QLineF> lines;
    for (double x = std::ceil(box.min().x() / step) * step; x <= box.max().x(); x += step) {
        const double px = std::floor(transform.toPixels({x, 0}).x()) + 0.5;
        lines.append({px, 0, px, static_cast<double>(size.height())});
    }
    for (double y = std::ceil(box.min().y() / step) * step; y <= box.max().y(); y += step) {
        const double py = std::floor(transform.toPixels({0, y}).y()) + 0.5;
        lines.append({0, py, static_cast<double>(size.width()), py});
    }
    return lines;
}

} // namespace

double gridStep(double pixelsPerMillimetre, double leastPixels)
{
    return std::pow(10, std::ceil(std::log10(leastPixels / pixelsPerMillimetre) - 1e-9));
}

void paintGrid(QPainter& painter, const PatternTransform& transform, const QSize& size, const ViewColors& colors)
{
    const double step = gridStep(transform.scale());
    // The finer lines come in slowly, so that zooming never makes the grid jump.
    const double share = std::clamp((step * transform.scale() - 9) / 30, 0.0, 1.0);
    painter.setRenderHint(QPainter::Antialiasing, false);
    if (share > 0.05) {
        painter.setPen(mixed(colors.canvas, colors.gridMinor, share));
        painter.drawLines(gridLines(transform, size, step));
    }
    painter.setPen(mixed(colors.gridMinor, colors.gridMajor, share));
    painter.drawLines(gridLines(transform, size, step * 10));
    painter.setRenderHint(QPainter::Antialiasing, true);
}

double scaleBarLength(double pixelsPerMillimetre, double mostPixels)
{
    const double most = mostPixels / pixelsPerMillimetre;
    const double decade = std::pow(10, std::floor(std::log10(most) + 1e-9));
    for (const double factor : {5.0, 2.0})
        if (factor * decade <= most * (1 + 1e-9))
            return factor * decade;
    return decade;
}

QRectF scaleBarPlace(const PatternTransform& transform, const QSize& size)
{
    const double width = std::round(scaleBarLength(transform.scale()) * transform.scale());
    return {34.5, size.height() - 36.5, width, 22}; // clear of a ruler
}

void paintScaleBar(QPainter& painter, const PatternTransform& transform, const QSize& size,
                   const ViewColors& colors)
{
    const double length = scaleBarLength(transform.scale());
    const QRectF place = scaleBarPlace(transform, size);
    const double left = place.left(), width = place.width(), bottom = place.bottom();
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(colors.mutedLabel, 1));
    const QVector<QPointF> bar{
        {left, bottom - 5}, {left, bottom}, {left + width, bottom}, {left + width, bottom - 5}};
    painter.drawPolyline(bar.data(), static_cast<int>(bar.size()));
    painter.setRenderHint(QPainter::Antialiasing, true);
    painter.drawText(place.adjusted(0, 0, 0, -4), Qt::AlignCenter | Qt::TextDontClip, lengthText(length));
}

} // namespace bolster
