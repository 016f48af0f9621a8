#include "StretchPick.h"

#include "CurvePath.h"
#include "Document.h"
#include "Selection.h"
#include "StretchToFix.h"

#include <QPainter>

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

} // namespace bolster
