#include "StretchPick.h"

#include "ArcLength.h"
#include "CurvePath.h"
#include "Document.h"
#include "Selection.h"
#include "StretchToFix.h"
#include "Units.h"
#include "ViewColors.h"

#include <QPainter>

#include <cmath>

namespace bolster {

namespace {

// Pixels.
constexpr double lengthGap = 12;
constexpr double lengthPadding = 4;
constexpr double pointerWidth = 5;

/// For a text beside a place of a line; `out` need not be of length 1.
QRectF lengthBox(const QPainter& painter, QPointF on, QPointF out, const QString& text)
{
    const double size = std::hypot(out.x(), out.y());
    out = size > 0 ? out / size : QPointF(0, 1);
    const QFontMetricsF metrics(painter.font());
    QRectF box(QPointF(),
               QSizeF(metrics.horizontalAdvance(text) + 2 * lengthPadding, metrics.height() + lengthPadding));
    const double reach = std::abs(out.x()) * box.width() / 2 + std::abs(out.y()) * box.height() / 2;
    box.moveCenter(on + (lengthGap + reach) * out);
    return box;
}

void paintLength(QPainter& painter, const ViewColors& colors, const QRectF& box, const QString& text)
{
    painter.setPen(QPen(colors.accent, 1));
    painter.setBrush(colors.pointFill);
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(colors.label);
    painter.drawText(box, Qt::AlignCenter, text);
}

/// From the box to what it belongs to.
void paintPointer(QPainter& painter, const ViewColors& colors, QPointF on, const QRectF& box)
{
    const QPointF way = box.center() - on;
    const double length = std::hypot(way.x(), way.y());
    if (!(length > 0))
        return;
    const QPointF side = QPointF(-way.y(), way.x()) / length * pointerWidth;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors.accent);
    painter.drawPolygon(QPolygonF{on, box.center() + side, box.center() - side});
}

bool meetsOtherPatch(const PatternToolContext& context, const QRectF& box, ElementId own)
{
    const Vec2 a = context.transform().toLayout(box.topLeft()), b = context.transform().toLayout(box.bottomRight());
    const QRectF area = QRectF(toPoint(a), toPoint(b)).normalized();
    for (const auto& [id, patch] : context.scene().patches())
        if (id != own && patch.path.boundingRect().intersects(area) && patch.path.intersects(area))
            return true;
    return false;
}

} // namespace

std::optional<Stretch> stretchUnder(PatternToolContext& context, QPointF pixel)
{
    const PatternHit hit = context.hit(pixel);
    const PatternPatch* patch = context.scene().patch(hit.patch);
    if (!patch || (hit.kind != PatternHit::Kind::Outline && hit.kind != PatternHit::Kind::Point))
        return std::nullopt;
    const BSpline2& outline = patch->patch().outline;
    const double t = hit.kind == PatternHit::Kind::Point ? outline.parameterOfPoint(hit.point) : hit.parameter;
    if (const auto selected = stretchThroughPoints(context.document().design(), context.selection(), hit.patch);
        selected && stretchContains(*selected, outline, t))
        return selected;
    const auto [first, last] = context.scene().stretches().equal_range(hit.seam);
    for (auto found = first; found != last; ++found)
        if (found->second.patch == hit.patch && found->second.contains(outline, t))
            return Stretch{hit.patch, found->second.from, outline.wrapped(found->second.to)};
    return outlineEdgeAt(hit.patch, outline, t);
}

void paintStretch(QPainter& painter, const PatternToolContext& context, const Stretch& stretch, const QColor& color)
{
    if (const PatternPatch* patch = context.scene().patch(stretch.patch))
        paintStretch(painter, context, patch->patch(), stretch, color);
}

void paintStretch(QPainter& painter, const PatternToolContext& context, const Patch& on, const Stretch& stretch,
                  const QColor& color)
{
    const double end = unwrappedEnd(stretch.from, stretch.to, on.outline.domainStart(), on.outline.domainEnd());
    const QPainterPath path =
        curvePath(on.outline, stretch.from, end, [&on](const Vec2& p) { return toLayout(on, p); });
    const QPainterPath drawn = context.transform().matrix().map(path);
    painter.strokePath(drawn, QPen(color, 4.5, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.setPen(QPen(color, 1.6));
    painter.setBrush(painter.background().color());
    for (const double share : {0.0, 1.0})
        painter.drawEllipse(drawn.pointAtPercent(share), 3.5, 3.5);
}

void paintEdgeLength(QPainter& painter, const ViewColors& colors, const PatternToolContext& context,
                     const Stretch& stretch)
{
    if (const PatternPatch* patch = context.scene().patch(stretch.patch))
        paintEdgeLength(painter, colors, context, patch->patch(), stretch);
}

void paintEdgeLength(QPainter& painter, const ViewColors& colors, const PatternToolContext& context,
                     const Patch& patch, const Stretch& stretch)
{
    const BSpline2& outline = patch.outline;
    const ArcLength2 lengths(outline);
    const double end = unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd());
    const double from = lengths.at(stretch.from), to = lengths.at(end);
    const double middle = outline.wrapped(lengths.parameterAt((from + to) / 2));
    const auto pixel = [&](const Vec2& at) { return context.transform().toPixels(toLayout(patch, at)); };
    const QPointF on = pixel(outline.at(middle)), ahead = pixel(outline.at(middle) + outline.derivative(middle));
    const QPointF way = ahead - on;
    // To the right of the outline's way when it runs counter-clockwise; pixels run downwards.
    const QPointF out = (outline.signedArea() > 0 ? 1 : -1) * QPointF(-way.y(), way.x());
    const QString text = lengthText(to - from);
    QRectF box = lengthBox(painter, on, out, text);
    if (meetsOtherPatch(context, box, stretch.patch)) // whose length it would seem to be
        box = lengthBox(painter, on, -out, text);
    paintPointer(painter, colors, on, box);
    paintLength(painter, colors, box, text);
}

void paintLengthBeside(QPainter& painter, const ViewColors& colors, QPointF on, QPointF out, const QString& text)
{
    paintLength(painter, colors, lengthBox(painter, on, out, text), text);
}

} // namespace bolster
