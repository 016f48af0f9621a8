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
    const PatternPatch* patch = context.scene().patch(stretch.patch);
    if (!patch)
        return;
    const Patch& on = patch->patch();
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
    const PatternPatch* patch = context.scene().patch(stretch.patch);
    if (!patch)
        return;
    const BSpline2& outline = patch->patch().outline;
    const ArcLength2 lengths(outline);
    const double end = unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd());
    const double from = lengths.at(stretch.from), to = lengths.at(end);
    const double middle = outline.wrapped(lengths.parameterAt((from + to) / 2));
    const auto pixel = [&](const Vec2& at) { return context.transform().toPixels(toLayout(patch->patch(), at)); };
    const QPointF on = pixel(outline.at(middle)), ahead = pixel(outline.at(middle) + outline.derivative(middle));
    const QPointF way = ahead - on;
    // To the right of the outline's way when it runs counter-clockwise; pixels run downwards.
    const QPointF out = (outline.signedArea() > 0 ? 1 : -1) * QPointF(-way.y(), way.x());
    paintLengthBeside(painter, colors, on, out, lengthText(to - from));
}

void paintLengthBeside(QPainter& painter, const ViewColors& colors, QPointF on, QPointF out, const QString& text)
{
    constexpr double gap = 16, padding = 4; // pixels
    const double size = std::hypot(out.x(), out.y());
    out = size > 0 ? out / size : QPointF(0, 1);
    const QFontMetricsF metrics(painter.font());
    QRectF box(QPointF(), QSizeF(metrics.horizontalAdvance(text) + 2 * padding, metrics.height() + padding));
    const double reach = std::abs(out.x()) * box.width() / 2 + std::abs(out.y()) * box.height() / 2;
    box.moveCenter(on + (gap - padding + reach) * out);
    painter.setPen(QPen(colors.accent, 1));
    painter.setBrush(colors.pointFill);
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(colors.label);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace bolster
