#include "PatternMarks.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QPainter>
#include <QVector>

#include <algorithm>
#include <cmath>
#include <optional>

namespace bolster {

namespace {

struct Spot {
    QPointF at;
    QPointF along; ///< unit
};

/// A path as a line of straight pieces that can be walked by length.
class Walk {
public:
    explicit Walk(const QPainterPath& path)
    {
        const QList<QPolygonF> parts = path.toSubpathPolygons();
        if (!parts.isEmpty())
            m_points = parts.front();
        m_lengths.append(0);
        for (qsizetype i = 1; i < m_points.size(); ++i)
            m_lengths.append(m_lengths.back() + QLineF(m_points[i - 1], m_points[i]).length());
    }

    double length() const { return m_lengths.back(); }

    Spot at(double s) const
    {
        if (m_points.size() < 2)
            return {m_points.isEmpty() ? QPointF() : m_points.front(), QPointF(1, 0)};
        const auto after = std::upper_bound(m_lengths.begin() + 1, m_lengths.end() - 1, s);
        const qsizetype i = after - m_lengths.begin();
        const QLineF piece(m_points[i - 1], m_points[i]);
        const double length = std::max(piece.length(), 1e-9);
        const QPointF along = QPointF(piece.dx(), piece.dy()) / length;
        return {piece.p1() + along * (s - m_lengths[i - 1]), along};
    }

private:
    QPolygonF m_points;
    QVector<double> m_lengths;
};

QFont seamLabelFont(QFont font)
{
    font.setPointSizeF(0.85 * font.pointSizeF());
    font.setBold(true);
    return font;
}

QRectF seamLabelBox(const QFont& font, QPointF centre, const QString& label)
{
    const QFontMetricsF metrics(font);
    const double height = metrics.height();
    const double width = std::max(height, metrics.horizontalAdvance(label) + 6);
    return {centre - QPointF(width, height) / 2, QSizeF(width, height)};
}

/// Letters on a ground of the seam's colour: coloured letters alone would be hard to read.
void paintSeamLabel(QPainter& painter, const QRectF& box, const QString& label, const QColor& color)
{
    painter.save();
    painter.setFont(seamLabelFont(painter.font()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRoundedRect(box, box.height() / 2, box.height() / 2);
    painter.setPen(qGray(color.rgb()) > 120 ? Qt::black : Qt::white);
    painter.drawText(box, Qt::AlignCenter, label);
    painter.restore();
}

/// Where an arrow lies, and the letter behind it.
struct ArrowPlace {
    QPointF centre;
    QPointF along; ///< unit
    QPointF inward;
    QRectF head;
    QRectF letter; ///< empty: none
};

constexpr double arrowSize = 4.5, strongArrowSize = 6; // pixels

/// The first that is free, if there is one.
std::optional<ArrowPlace> arrowPlace(const SeamArrow& arrow, const QString& label, const QFont& font,
                                     const std::vector<QRectF>& taken)
{
    const Walk walk(arrow.stretch);
    const double size = arrow.strong ? strongArrowSize : arrowSize;
    const QSizeF room = seamLabelBox(font, {}, label).size();
    const auto isFree = [&](const QRectF& box) {
        return std::ranges::none_of(taken, [&](const QRectF& other) { return other.intersects(box); });
    };
    // Not in the middle: in narrow patches it would meet the arrow of the other side. Short ones keep off the
    // corners.
    const bool shortOne = walk.length() < 110;
    for (const double share : {shortOne ? 0.6 : 0.33, 0.2, 0.8, 0.66, 0.45}) {
        const Spot spot = walk.at(share * walk.length());
        // Pixels run downwards: there the left of the layout is (y, -x).
        const QPointF inward = QPointF(spot.along.y(), -spot.along.x()) * (arrow.leftIsInside ? 1 : -1);
        const QPointF centre = spot.at + inward * (arrow.strong ? 14 : 9.5);
        ArrowPlace place{centre, spot.along, inward, QRectF(centre.x(), centre.y(), 0, 0), {}};
        place.head.adjust(-size, -size, size, size);
        if (!label.isEmpty()) {
            const QPointF along = spot.along;
            const double gap =
                size + 3 + (std::abs(along.x()) * room.width() + std::abs(along.y()) * room.height()) / 2;
            if (share * walk.length() <= gap + 6)
                continue;
            place.letter = seamLabelBox(font, centre - along * gap, label);
        }
        if (isFree(place.head) && (place.letter.isEmpty() || isFree(place.letter)))
            return place;
    }
    return std::nullopt;
}

} // namespace

void paintFixationMarks(QPainter& painter, const QPainterPath& stretch, bool counterClockwise, const QColor& color,
                        bool strong)
{
    constexpr double gap = 7;
    constexpr double depth = 6;
    const Walk walk(stretch);
    // Far zoomed in a stretch is much longer than the window; the marks then stay apart further.
    const int count = std::clamp(static_cast<int>(walk.length() / gap), 1, 1000);
    const double step = walk.length() / count;
    QVector<QLineF> ticks;
    for (int i = 0; i < count; ++i) {
        const Spot spot = walk.at((i + 0.5) * step);
        QPointF outward(-spot.along.y(), spot.along.x());
        if (!counterClockwise)
            outward = -outward;
        ticks.append({spot.at, spot.at + (outward + 0.7 * spot.along) * depth * 0.8});
    }
    painter.setPen(QPen(color, strong ? 1.8 : 1.1));
    painter.drawLines(ticks);
    painter.setBrush(Qt::NoBrush);
    painter.strokePath(stretch, QPen(color, strong ? 3.4 : 2.4, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
}

QRectF paintSeamArrow(QPainter& painter, const SeamArrow& arrow, const QColor& color, std::vector<QRectF>& taken)
{
    if (Walk(arrow.stretch).length() < 30)
        return {};
    const QFont font = seamLabelFont(painter.font());
    auto place = arrowPlace(arrow, arrow.label, font, taken);
    if (!place)
        place = arrowPlace(arrow, {}, font, taken);
    if (!place)
        return {};
    const double size = arrow.strong ? strongArrowSize : arrowSize;
    const auto& [centre, along, inward, headBox, letter] = *place;
    QPainterPath head(centre + along * size);
    head.lineTo(centre - along * size * 0.8 + inward * size * 0.8);
    head.lineTo(centre - along * size * 0.4);
    head.lineTo(centre - along * size * 0.8 - inward * size * 0.8);
    head.closeSubpath();
    painter.fillPath(head, color);
    taken.push_back(headBox);
    if (letter.isEmpty())
        return headBox;
    paintSeamLabel(painter, letter, arrow.label, color);
    taken.push_back(letter);
    return headBox.united(letter);
}

void paintSeamLink(QPainter& painter, const QPainterPath& a, const QPainterPath& b, const QColor& color)
{
    const Walk first(a);
    const Walk second(b);
    painter.setPen(QPen(color, 1.2, Qt::DashLine));
    for (const double share : {0.0, 1.0})
        painter.drawLine(first.at(share * first.length()).at, second.at(share * second.length()).at);
    painter.setPen(QPen(color, 1.6));
    painter.drawLine(first.at(first.length() / 2).at, second.at(second.length() / 2).at);
}

void paintFancyStrip(QPainter& painter, const QPainterPath& middle, double width, const QColor& color, bool strong)
{
    constexpr double narrowest = 3; // narrower ones would be one thick line
    painter.setBrush(Qt::NoBrush);
    if (width >= narrowest) {
        QPainterPathStroker stroker;
        stroker.setWidth(width);
        stroker.setCapStyle(Qt::FlatCap);
        stroker.setJoinStyle(Qt::MiterJoin);
        QColor fill = color;
        fill.setAlphaF(strong ? 0.30F : 0.18F);
        const QPainterPath strip = stroker.createStroke(middle).simplified();
        painter.fillPath(strip, fill);
        painter.strokePath(strip, QPen(color, strong ? 1.3 : 0.8));
    }
    QPen stitches(color, strong ? 2.2 : 1.5, Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
    stitches.setDashPattern({4, 2.5});
    painter.strokePath(middle, stitches);
}

void paintLineName(QPainter& painter, const QPainterPath& line, const QString& name, double gap,
                   const QColor& color, bool wanted)
{
    const Walk walk(line);
    const QFontMetricsF metrics(painter.font());
    const double width = metrics.horizontalAdvance(name);
    if (walk.length() < (wanted ? 1.1 : 6) * width)
        return;
    // Along the chord that it will lie beside, read from the left or from below.
    const double middle = 0.5 * walk.length();
    const QPointF from = walk.at(middle - 0.5 * width).at, to = walk.at(middle + 0.5 * width).at;
    double angle = std::atan2(to.y() - from.y(), to.x() - from.x()) * 180 / M_PI;
    if (angle > 89 || angle < -91)
        angle -= 180;
    painter.save();
    painter.translate((from + to) / 2);
    painter.rotate(angle);
    painter.setPen(color);
    painter.drawText(QPointF(-0.5 * width, -gap - metrics.descent() - 2), name);
    painter.restore();
}

void paintGrainArrow(QPainter& painter, QPointF centre, QPointF half, const QColor& color)
{
    painter.setPen(QPen(color, 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawLine(centre - half, centre + half);
    const double length = std::max(std::hypot(half.x(), half.y()), 1e-9);
    const QPointF along = half / length * 4;
    const QPointF across(-along.y() * 0.7, along.x() * 0.7);
    for (const double side : {1.0, -1.0}) {
        const QPointF tip = centre + half * side;
        painter.drawPolyline(QPolygonF{tip - along * side + across, tip, tip - along * side - across});
    }
}

} // namespace bolster
