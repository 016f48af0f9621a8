#include "PatternCut.h"

#include "CutPattern.h"
#include "PatternScene.h"
#include "PatternTransform.h"
#include "Selection.h"
#include "ViewColors.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double leastLetters = 11; // pixels from line to line: smaller ones nobody reads
constexpr double markRadius = 4;    // pixels

/// From a piece's coordinates to pixels: as it will be when the fabric has shrunk, so that all lies where the
/// outline says.
class PiecePlace {
public:
    PiecePlace(const CutPiece& piece, const PatternPatch& patch, const PatternTransform& transform)
        : m_piece(piece)
        , m_patch(patch.patch())
        , m_transform(transform)
    {}

    QPointF operator()(const Vec2& point) const
    {
        return m_transform.toPixels(toLayout(m_patch, m_piece.shrunk(point)));
    }
    /// Of words, degrees counter-clockwise: on the screen nobody reads upside down.
    double upright(double rotation) const
    {
        const double turned = std::remainder(rotation + m_patch.rotation, 360);
        return std::abs(turned) > 91 ? turned - 180 : turned;
    }

    QPainterPath path(const std::vector<LinePoint>& line, bool closed) const
    {
        QPainterPath path;
        for (std::size_t i = 0; i < line.size(); ++i)
            i == 0 ? path.moveTo((*this)(line[i].at)) : path.lineTo((*this)(line[i].at));
        if (closed)
            path.closeSubpath();
        return path;
    }

private:
    const CutPiece& m_piece;
    const Patch& m_patch;
    const PatternTransform& m_transform;
};

void paintLabel(QPainter& painter, const PieceLabel& label, const PiecePlace& place, double scale,
                const QColor& color)
{
    const double step = label.height * scale;
    painter.save();
    painter.translate(place(label.at));
    painter.rotate(-place.upright(label.rotation));
    QFont font = painter.font();
    font.setPixelSize(std::max(1, static_cast<int>(std::lround(0.72 * step))));
    painter.setFont(font);
    painter.setPen(color);
    double y = -step * static_cast<double>(label.lines.size()) / 2;
    for (const std::string& line : label.lines) {
        painter.drawText(QRectF(-1000, y, 2000, step), Qt::AlignCenter, QString::fromStdString(line));
        y += step;
    }
    painter.restore();
}

QPainterPath beside(const std::vector<QPolygonF>& words, const QRectF& window)
{
    QPainterPath path;
    path.setFillRule(Qt::OddEvenFill); // words of two patches do not meet
    path.addRect(window.adjusted(-1, -1, 1, 1));
    for (const QPolygonF& frame : words)
        path.addPolygon(frame);
    return path;
}

void paintGrain(QPainter& painter, const GrainLine& grain, const PiecePlace& place)
{
    if (grain.from == grain.to)
        return;
    const QPointF from = place(grain.from), to = place(grain.to);
    const double length = std::hypot(to.x() - from.x(), to.y() - from.y());
    if (length < 12)
        return;
    const QPointF along = (to - from) / length, side(-along.y(), along.x());
    painter.drawLine(from, to);
    const auto head = [&](const QPointF& tip, const QPointF& back) {
        painter.drawLine(tip, tip + 7 * back + 3 * side);
        painter.drawLine(tip, tip + 7 * back - 3 * side);
    };
    head(to, -along);
    if (grain.nap != Nap::OneWay)
        head(from, along);
}

} // namespace

const CutPiece* labelledPiece(const CutPattern* cut, ElementId patch)
{
    if (!cut)
        return nullptr;
    const auto piece = std::ranges::lower_bound(cut->pieces, patch, {}, &CutPiece::patch);
    const bool there = piece != cut->pieces.end() && piece->patch == patch && !piece->label.lines.empty();
    return there ? &*piece : nullptr;
}

const PieceLabel* readableLabel(const CutPattern* cut, ElementId patch, const PatternTransform& transform)
{
    const CutPiece* piece = labelledPiece(cut, patch);
    return piece && piece->label.height * transform.scale() >= leastLetters ? &piece->label : nullptr;
}

PatternLabel nameOnPiece(const CutPiece& piece, const PatternPatch& patch, const PatternTransform& transform,
                         const QFont& font)
{
    if (!patch.patch().cutting.label)
        return {patch, transform, font};
    const PiecePlace place(piece, patch, transform);
    const double angle = place.upright(piece.label.rotation) * std::numbers::pi / 180;
    const PatternLabel level(patch, transform, font, place(piece.label.at), angle);
    const Vec2 room = transform.scale() * patch.box.sizes();
    const bool tooLong = level.box().width() > room.x() && level.box().width() < room.y(); // for a narrow piece
    return tooLong ? PatternLabel(patch, transform, font, place(piece.label.at), angle + std::numbers::pi / 2)
                   : level;
}

QPolygonF labelFrame(const CutPiece& piece, const PatternPatch& patch, const PatternTransform& transform,
                     const QFont& font)
{
    const PieceLabel& label = piece.label;
    if (label.height * transform.scale() < leastLetters)
        return nameOnPiece(piece, patch, transform, font).frame();
    const PiecePlace place(piece, patch, transform);
    const double height = label.height * static_cast<double>(label.lines.size());
    const Eigen::Rotation2Dd turn(label.rotation * std::numbers::pi / 180);
    QPolygonF frame;
    for (const auto& [x, y] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
        frame << place(label.at + turn * Vec2(x * (label.width + label.height), y * (height + label.height)));
    return frame;
}

void paintAllowances(QPainter& painter, const CutPattern& pattern, const PatternScene& scene,
                     const PatternTransform& transform, const ViewColors& colors)
{
    for (const CutPiece& piece : pattern.pieces) {
        const PatternPatch* patch = scene.patch(piece.patch);
        if (!patch)
            continue;
        const QPainterPath path = PiecePlace(piece, *patch, transform).path(piece.cut, true);
        painter.fillPath(path, mixed(colors.canvas, patch->fabric, 0.12));
        painter.strokePath(path, QPen(mixed(colors.canvas, colors.outline, 0.55), 1));
    }
}

void paintCutMarks(QPainter& painter, const CutPattern& pattern, const PatternScene& scene,
                   const PatternTransform& transform, const ViewColors& colors, const Selection& selection,
                   const std::vector<QPolygonF>& words)
{
    const QPainterPath besideWords = beside(words, painter.window());
    const QColor ink = mixed(colors.canvas, colors.outline, 0.75);
    for (const CutPiece& piece : pattern.pieces) {
        const PatternPatch* patch = scene.patch(piece.patch);
        if (!patch)
            continue;
        const PiecePlace place(piece, *patch, transform);
        painter.setBrush(Qt::NoBrush);
        for (const CutNotch& notch : piece.notches) {
            const bool marked = notch.element != noElement &&
                                (selection.contains(notch.element) || selection.hovered() == notch.element);
            painter.setPen(QPen(marked ? colors.accent : ink, marked ? 2 : 1.2));
            for (const std::vector<Vec2>& line : notchLines(notch)) {
                QPolygonF points;
                for (const Vec2& point : line)
                    points << place(point);
                painter.drawPolyline(points);
            }
        }
        painter.setPen(QPen(ink, 1));
        for (const CutHole& hole : piece.holes) {
            const double radius = std::max(2.0, hole.diameter / 2 * transform.scale());
            painter.drawEllipse(place(hole.at), radius, radius);
        }
        painter.save();
        painter.setClipPath(besideWords, Qt::IntersectClip);
        paintGrain(painter, piece.grain, place);
        painter.restore();
        if (const PieceLabel* label = readableLabel(&pattern, piece.patch, transform))
            paintLabel(painter, *label, place, transform.scale(), label->fits ? colors.label : colors.warning);
    }
    for (const auto& [id, mark] : scene.marks()) {
        const bool selected = selection.contains(id), hovered = selection.hovered() == id;
        painter.setPen(QPen(selected || hovered ? colors.accent : ink, selected ? 2 : 1.2));
        painter.setBrush(selected ? colors.accent : colors.pointFill);
        painter.drawEllipse(transform.toPixels(mark.place), markRadius, markRadius);
    }
}

} // namespace bolster
