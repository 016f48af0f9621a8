#include "SnapHints.h"

#include "Units.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

// Pixels.
constexpr double signSize = 5.5;
constexpr double overshoot = 24; // of a line beyond the point
constexpr double noteGap = 16;
constexpr double notePadding = 5;

struct SnapHints {
    Q_DECLARE_TR_FUNCTIONS(SnapHints)
};

QString hintText(const SnapHint& hint)
{
    switch (hint.kind) {
    case SnapHint::Kind::Point:
        return SnapHints::tr("Point");
    case SnapHint::Kind::Midpoint:
        return SnapHints::tr("Midpoint");
    case SnapHint::Kind::Outline:
        return SnapHints::tr("On an outline");
    case SnapHint::Kind::Alignment:
        return SnapHints::tr("Aligned");
    case SnapHint::Kind::Direction:
        return SnapHints::tr("Direction %1").arg(angleText(hint.value));
    case SnapHint::Kind::Perpendicular:
        return SnapHints::tr("Perpendicular");
    case SnapHint::Kind::EqualLength:
        return SnapHints::tr("As long: %1").arg(lengthText(hint.value));
    case SnapHint::Kind::Guide:
        return SnapHints::tr("Guide");
    case SnapHint::Kind::Grid:
        return SnapHints::tr("Grid");
    }
    return {};
}

void paintHintLine(QPainter& painter, QPointF from, QPointF to)
{
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    if (length > 1)
        painter.drawLine(from, to + overshoot / length * way);
}

/// The small square of a right angle, on the side from which the line comes.
void paintRightAngle(QPainter& painter, QPointF at, QPointF to)
{
    const QPointF way = to - at;
    const double length = std::hypot(way.x(), way.y());
    if (length < 4 * signSize)
        return;
    const QPointF along = 2 * signSize / length * way;
    const QPointF across(-along.y(), along.x());
    painter.drawPolyline(QPolygonF({at + along, at + along + across, at + across}));
}

/// Two short strokes across the middle of an edge, as draughtsmen mark equal lengths.
void paintEqualSign(QPainter& painter, QPointF from, QPointF to)
{
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    if (length < 4 * signSize)
        return;
    const QPointF along = way / length;
    const QPointF across(-along.y() * signSize, along.x() * signSize);
    for (const double shift : {-2.0, 2.0}) {
        const QPointF middle = (from + to) / 2 + shift * along;
        painter.drawLine(middle - across, middle + across);
    }
}

void paintPointSign(QPainter& painter, const SnapHint& hint, QPointF at)
{
    const double s = signSize;
    if (hint.kind == SnapHint::Kind::Midpoint)
        painter.drawPolygon(QPolygonF({at + QPointF(0, -s), at + QPointF(s, s), at + QPointF(-s, s)}));
    else if (hint.kind == SnapHint::Kind::Point)
        painter.drawRect(QRectF(at - QPointF(s, s), QSizeF(2 * s, 2 * s)));
    else
        painter.drawEllipse(at, s, s);
}

} // namespace

void paintSnapHints(QPainter& painter, const ViewColors& colors, const PatternTransform& transform,
                    const std::vector<SnapHint>& hints)
{
    painter.setBrush(Qt::NoBrush);
    for (const SnapHint& hint : hints) {
        const QPointF from = transform.toPixels(hint.from);
        const QPointF to = transform.toPixels(hint.to);
        painter.setPen(QPen(colors.snap, 1, Qt::DashLine));
        if (hint.kind == SnapHint::Kind::Alignment || hint.kind == SnapHint::Kind::Direction ||
            hint.kind == SnapHint::Kind::Perpendicular)
            paintHintLine(painter, from, to);
        painter.setPen(QPen(colors.snap, 1.4));
        if (hint.kind == SnapHint::Kind::Perpendicular)
            paintRightAngle(painter, from, to);
        else if (hint.kind == SnapHint::Kind::EqualLength)
            paintEqualSign(painter, from, to);
        else if (hint.kind == SnapHint::Kind::Alignment)
            painter.drawEllipse(from, 3, 3);
        if (hint.kind != SnapHint::Kind::Direction)
            paintPointSign(painter, hint, to);
    }
}

QString snapText(const std::vector<SnapHint>& hints)
{
    QStringList texts;
    for (const SnapHint& hint : hints)
        texts << hintText(hint);
    texts.removeDuplicates();
    return texts.join(QStringLiteral(" \u00b7 "));
}

void paintNote(QPainter& painter, const ViewColors& colors, QPointF beside, QStringList lines)
{
    lines.removeAll(QString());
    if (lines.isEmpty())
        return;
    const QFontMetricsF metrics(painter.font());
    double width = 0;
    for (const QString& line : lines)
        width = std::max(width, metrics.horizontalAdvance(line));
    const double height = metrics.height() * static_cast<double>(lines.size());
    QRectF box(beside + QPointF(noteGap, noteGap), QSizeF(width + 2 * notePadding, height + 2 * notePadding));
    const QRectF window = painter.window();
    if (box.right() > window.right())
        box.moveRight(beside.x() - noteGap);
    if (box.bottom() > window.bottom())
        box.moveBottom(beside.y() - noteGap);
    QColor ground = colors.canvas;
    ground.setAlphaF(0.92F);
    painter.setPen(QPen(colors.gridMajor, 1));
    painter.setBrush(ground);
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(colors.label);
    painter.drawText(box.adjusted(notePadding, notePadding, 0, 0), Qt::AlignLeft | Qt::AlignTop, lines.join(u'\n'));
}

} // namespace bolster
