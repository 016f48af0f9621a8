#include "DartPicture.h"

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
    painter.setPen(
        QPen(hasEqualLegs(patch, dart) ? colors.snap : mixed(colors.canvas, colors.accent, 0.5), 1, Qt::DotLine));
    painter.drawLine(pixel(axis.middle), pixel(axis.middle + depth * axis.inwards));
}

} // namespace

bool hasEqualLegs(const Patch& patch, const edits::DartShape& dart)
{
    const auto [from, tip, to] = wedge(patch, dart);
    return std::abs((tip - from).norm() - (tip - to).norm()) < equalLegs;
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

QStringList dartFigures(const Patch& patch, const edits::DartShape& dart)
{
    const edits::DartAxis axis = edits::dartAxis(patch.outline, dart);
    return {dartText(QT_TRANSLATE_NOOP("DartPicture", "Mouth %1")).arg(lengthText(axis.width)),
            dartText(QT_TRANSLATE_NOOP("DartPicture", "Depth %1"))
                .arg(lengthText((dart.tip - axis.middle).dot(axis.inwards))),
            hasEqualLegs(patch, dart) ? dartText(QT_TRANSLATE_NOOP("DartPicture", "Legs of one length"))
                                      : QString()};
}

void paintDart(QPainter& painter, const ViewColors& colors, const PatternToolContext& context, const Patch& patch,
               const edits::DartShape& dart, bool good)
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
    // On the outer side of each leg.
    const QPointF middle = (legs[0] + legs[2]) / 2;
    for (const int end : {0, 2}) {
        const QPointF on = (legs[end] + legs[1]) / 2;
        const QPointF along = legs[1] - legs[end];
        QPointF out(along.y(), -along.x());
        if (QPointF::dotProduct(out, on - (middle + legs[1]) / 2) < 0)
            out = -out;
        paintLengthBeside(painter, colors, on, out, lengthText(((end == 0 ? from : to) - tip).norm()));
    }
}

} // namespace bolster
