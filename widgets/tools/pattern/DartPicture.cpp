#include "DartPicture.h"

#include "ArcLength.h"
#include "StretchPick.h"
#include "Units.h"
#include "ViewColors.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace bolster {

namespace {

// Pixels.
constexpr double axisReach = 9;
constexpr double outlineReach = 12;
constexpr double tipRadius = 4;

constexpr double equalLegs = 0.05; // mm

QString dartText(const char* words)
{
    return QCoreApplication::translate("DartPicture", words);
}

/// From one end of the mouth to the tip and on to the other one.
std::array<Vec2, 3> wedge(const Patch& patch, const edits::DartShape& dart)
{
    const BSpline2& outline = patch.outline;
    return {outline.at(outline.wrapped(dart.from)), dart.tip, outline.at(outline.wrapped(dart.to))};
}

/// On the line on which both legs are equal, if there is one.
void paintAxis(QPainter& painter, const ViewColors& colors, const PatternToolContext& context, const Patch& patch,
               const edits::DartShape& dart)
{
    const edits::DartAxis axis = edits::dartAxis(patch.outline, dart);
    const double depth = std::max((dart.tip - axis.middle).dot(axis.inwards), 0.0) + 40;
    const auto pixel = [&](const Vec2& at) { return context.transform().toPixels(toLayout(patch, at)); };
    painter.setPen(QPen(hasEqualLegs(patch, dart) ? colors.snap : colors.accent, 1.4, Qt::DotLine));
    painter.drawLine(pixel(axis.middle), pixel(axis.middle + depth * axis.inwards));
}

/// Each where it is: the mouth outside, legs on their outer side, the depth beyond the tip.
void paintMeasures(QPainter& painter, const ViewColors& colors, const Patch& patch, const edits::DartShape& dart,
                   const QPolygonF& legs, bool mouth)
{
    const auto [from, tip, to] = wedge(patch, dart);
    const QPointF middle = (legs[0] + legs[2]) / 2;
    for (const int end : {0, 2}) {
        const QPointF on = (legs[end] + legs[1]) / 2, along = legs[1] - legs[end];
        QPointF out(along.y(), -along.x());
        if (QPointF::dotProduct(out, on - (middle + legs[1]) / 2) < 0)
            out = -out;
        paintLengthBeside(painter, colors, on, out, lengthText(((end == 0 ? from : to) - tip).norm()));
    }
    if (mouth)
        paintLengthBeside(painter, colors, middle, middle - legs[1], mouthText(patch, dart));
    const edits::DartAxis axis = edits::dartAxis(patch.outline, dart);
    const QString depth =
        dartText(hasEqualLegs(patch, dart) ? QT_TRANSLATE_NOOP("DartPicture", "Depth %1, legs of one length")
                                           : QT_TRANSLATE_NOOP("DartPicture", "Depth %1"))
            .arg(lengthText((dart.tip - axis.middle).dot(axis.inwards)));
    paintLengthBeside(painter, colors, legs[1], legs[1] - middle, depth);
}

} // namespace

bool hasEqualLegs(const Patch& patch, const edits::DartShape& dart)
{
    const auto [from, tip, to] = wedge(patch, dart);
    return std::abs((tip - from).norm() - (tip - to).norm()) < equalLegs;
}

std::optional<double> placeOnOutline(const PatternToolContext& context, ElementId patch,
                                     const PatternPointer& pointer)
{
    const PatternPatch* shown = context.scene().patch(patch);
    if (!shown || shown->patch().outline.empty())
        return std::nullopt;
    const BSpline2& outline = shown->patch().outline;
    const BSpline2::Closest closest = outline.closest(fromLayout(shown->patch(), pointer.layout));
    double nearest = context.transform().millimetres(outlineReach), best = closest.parameter;
    if (pointer.modifiers & (Qt::ControlModifier | Qt::AltModifier))
        return best;
    const ArcLength2 length(outline);
    const auto offer = [&](double t) {
        if (const double way = (outline.at(outline.wrapped(t)) - closest.point).norm(); way < nearest) {
            nearest = way;
            best = outline.wrapped(t);
        }
    };
    for (const PatternEdge& edge : shown->edges) {
        if (edge.ends)
            offer(edge.from);
        offer(length.parameterAt((length.at(edge.from) + length.at(edge.to)) / 2));
    }
    return best;
}

Vec2 snappedTip(const PatternToolContext& context, const Patch& patch, const edits::DartShape& dart, bool always)
{
    const edits::DartAxis axis = edits::dartAxis(patch.outline, dart);
    const double depth = (dart.tip - axis.middle).dot(axis.inwards);
    const double off = (dart.tip - (axis.middle + depth * axis.inwards)).norm();
    if (!always && off > context.transform().millimetres(axisReach))
        return dart.tip;
    return axis.middle + std::round(depth) * axis.inwards;
}

QString mouthText(const Patch& patch, const edits::DartShape& dart)
{
    return dartText(QT_TRANSLATE_NOOP("DartPicture", "Mouth %1"))
        .arg(lengthText(edits::dartAxis(patch.outline, dart).width));
}

void paintDart(QPainter& painter, const ViewColors& colors, const PatternToolContext& context, const Patch& patch,
               const edits::DartShape& dart, bool good, bool mouth)
{
    const QColor color = good ? colors.accent : colors.error;
    const auto pixel = [&](const Vec2& at) { return context.transform().toPixels(toLayout(patch, at)); };
    const auto [from, tip, to] = wedge(patch, dart);
    QPolygonF legs;
    legs << pixel(from) << pixel(tip) << pixel(to);
    paintAxis(painter, colors, context, patch, dart);
    QColor fill = color;
    fill.setAlphaF(0.14F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawPolygon(legs);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(color, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(legs);
    painter.setBrush(colors.pointFill);
    painter.drawEllipse(legs[1], tipRadius, tipRadius);
    paintMeasures(painter, colors, patch, dart, legs, mouth);
}

} // namespace bolster
