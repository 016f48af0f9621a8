#include "CornerMeasure.h"

#include "CornerWay.h"
#include "LengthExpression.h"
#include "StretchPick.h"
#include "ViewColors.h"

namespace bolster {

namespace {

constexpr double shortestShown = 0.05; // mm

} // namespace

std::optional<double> typedAlongOutline(const BSpline2& outline, double t, const QString& text)
{
    const std::optional<double> typed = parseLength(text);
    std::optional<CornerWay> way = wayFromCorner(outline, t);
    if (!typed || !way)
        return std::nullopt;
    way->length = *typed;
    return endOfWay(outline, *way);
}

void paintWayFromCorner(QPainter& painter, const ViewColors& colors, const PatternToolContext& context,
                        ElementId id, const Patch& patch, double at)
{
    const std::optional<CornerWay> way = wayFromCorner(patch.outline, at);
    if (!way || way->length < shortestShown)
        return;
    const Stretch stretch = way->forwards ? Stretch{id, way->corner, at} : Stretch{id, at, way->corner};
    paintStretch(painter, context, patch, stretch, colors.accent);
    paintEdgeLength(painter, colors, context, patch, stretch);
}

} // namespace bolster
