#include "PatternGrid.h"

#include "Units.h"

#include <QLineF>
#include <QPainter>
#include <QSize>
#include <QVector>

#include <algorithm>
#include <array>
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

constexpr double gridInch = 25.4; // mm

bool inInches()
{
    return NumberStyles::now().length == LengthUnit::Inches;
}

/// The next power of ten.
double decimalStep(double least)
{
    return std::pow(10, std::ceil(std::log10(least) - 1e-9));
}

// Inches, and how rulers divide them.
struct InchStep {
    double inches;
    std::array<int, 3> parts; ///< the finest first; 1: not at all
};
constexpr InchStep inchSteps[] = {
    {1.0 / 64, {1, 1, 1}}, {1.0 / 32, {2, 1, 1}}, {1.0 / 16, {4, 2, 1}}, {1.0 / 8, {8, 4, 2}}, {1.0 / 4, {4, 2, 1}},
    {1.0 / 2, {8, 4, 2}},  {1, {16, 8, 4}},       {2, {8, 4, 2}},        {3, {12, 6, 3}},      {6, {12, 6, 3}},
    {12, {12, 6, 4}},      {24, {24, 12, 4}},     {60, {10, 5, 5}},      {120, {10, 5, 5}},    {240, {10, 5, 5}},
    {600, {10, 5, 5}},     {1200, {10, 5, 5}},    {6000, {10, 5, 5}},    {12000, {10, 5, 5}},
};

} // namespace

QString gridFigure(double length)
{
    constexpr int finest = 64;
    if (inInches() && NumberStyles::now().fraction > 0)
        return inchFractionText(length / gridInch, finest);
    return lengthFigure(length, 3);
}

QString gridLengthText(double length)
{
    return gridFigure(length) + lengthSuffix();
}

double gridStep(double pixelsPerMillimetre, double leastPixels)
{
    const double least = leastPixels / pixelsPerMillimetre * (1 - 1e-9);
    if (!inInches())
        return decimalStep(leastPixels / pixelsPerMillimetre);
    for (const double inches : {1.0 / 64, 1.0 / 8, 1.0, 12.0})
        if (inches * gridInch >= least)
            return inches * gridInch;
    return 12 * gridInch * decimalStep(least / (12 * gridInch));
}

double coarserGridStep(double step)
{
    if (!inInches())
        return step * 10;
    const double inches = step / gridInch;
    return step * (inches < 0.9 ? 8 : inches < 11 ? 12 : 10);
}

RulerStep rulerStep(double pixelsPerMillimetre, double leastPixels, double leastTick)
{
    if (inInches()) {
        for (const InchStep& step : inchSteps) {
            const double length = step.inches * gridInch;
            if (length * pixelsPerMillimetre < leastPixels)
                continue;
            const auto fits = [&](int parts) { return length / parts * pixelsPerMillimetre >= leastTick; };
            const auto* const parts = std::ranges::find_if(step.parts, fits);
            return {length, parts == step.parts.end() ? 1 : *parts};
        }
    }
    double step = gridStep(pixelsPerMillimetre, leastPixels);
    for (const double part : {0.2, 0.5})
        if (part * step * pixelsPerMillimetre >= leastPixels) {
            step *= part;
            break;
        }
    return {step, step * pixelsPerMillimetre / 10 >= leastTick ? 10 : 5};
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
    painter.drawLines(gridLines(transform, size, coarserGridStep(step)));
    painter.setRenderHint(QPainter::Antialiasing, true);
}

double scaleBarLength(double pixelsPerMillimetre, double mostPixels)
{
    const double most = mostPixels / pixelsPerMillimetre;
    if (inInches()) {
        double length = gridInch * inchSteps[0].inches;
        for (const InchStep& step : inchSteps)
            if (step.inches * gridInch <= most * (1 + 1e-9))
                length = step.inches * gridInch;
        return length;
    }
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
    painter.drawText(place.adjusted(0, 0, 0, -4), Qt::AlignCenter | Qt::TextDontClip, gridLengthText(length));
}

} // namespace bolster
