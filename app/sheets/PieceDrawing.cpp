#include "PieceDrawing.h"

#include <QPainter>
#include <QPainterPath>

#include <numbers>

namespace bolster {

namespace {

const QColor ink(0, 0, 0), sewingInk(0, 96, 192), innerInk(110, 110, 110);

QPointF toPoint(const Vec2& point)
{
    return {point.x(), point.y()};
}

class Drawing {
public:
    Drawing(QPainter& painter, const TablePiece& place, double thickness)
        : m_painter(painter)
        , m_place(place)
        , m_thickness(thickness)
    {}

    void pen(const QColor& color, double width, Qt::PenStyle style = Qt::SolidLine)
    {
        m_painter.setPen(QPen(color, width * m_thickness, style, Qt::FlatCap, Qt::MiterJoin));
        m_painter.setBrush(Qt::NoBrush);
    }
    void line(const std::vector<Vec2>& points, bool closed)
    {
        QPainterPath path;
        for (std::size_t i = 0; i < points.size(); ++i)
            i == 0 ? path.moveTo(toPoint(m_place.at(points[i]))) : path.lineTo(toPoint(m_place.at(points[i])));
        if (closed)
            path.closeSubpath();
        m_painter.drawPath(path);
    }
    void line(const std::vector<LinePoint>& line, bool closed)
    {
        std::vector<Vec2> points;
        for (const LinePoint& point : line)
            points.push_back(point.at);
        this->line(points, closed);
    }
    void circle(const Vec2& at, double radius) { m_painter.drawEllipse(toPoint(m_place.at(at)), radius, radius); }

    void label(const PieceLabel& label)
    {
        m_painter.save();
        m_painter.translate(toPoint(m_place.at(label.at)));
        m_painter.rotate(label.rotation + m_place.angle * 180 / std::numbers::pi);
        constexpr double points = 100; // fonts have sizes in whole numbers
        const double scale = 0.72 * label.height / points;
        m_painter.scale(scale, -scale);
        QFont font(QStringLiteral("DejaVu Sans"));
        font.setStyleHint(QFont::SansSerif);
        font.setPixelSize(static_cast<int>(points));
        m_painter.setFont(font);
        m_painter.setPen(ink);
        const double step = label.height / scale;
        double y = -step * static_cast<double>(label.lines.size()) / 2;
        for (const std::string& text : label.lines) {
            m_painter.drawText(QRectF(-20 * step * 10, y, 40 * step * 10, step), Qt::AlignCenter,
                               QString::fromStdString(text));
            y += step;
        }
        m_painter.restore();
    }

private:
    QPainter& m_painter;
    const TablePiece& m_place;
    double m_thickness;
};

} // namespace

void drawPiece(QPainter& painter, const CutPiece& piece, const TablePiece& place, const CutLayers& layers,
               double thickness)
{
    Drawing drawing(painter, place, thickness);
    if (layers.internal)
        for (const PieceLine& inner : piece.inner) {
            drawing.pen(inner.cut ? ink : innerInk, 0.25, inner.cut ? Qt::SolidLine : Qt::DashLine);
            drawing.line(inner.points, inner.closed);
        }
    drawing.pen(ink, 0.2);
    if (layers.holes)
        for (const CutHole& hole : piece.holes) {
            drawing.circle(hole.at, hole.diameter / 2);
            const double arm = hole.diameter / 2 + 2;
            drawing.line(std::vector<Vec2>{hole.at - Vec2(arm, 0), hole.at + Vec2(arm, 0)}, false);
            drawing.line(std::vector<Vec2>{hole.at - Vec2(0, arm), hole.at + Vec2(0, arm)}, false);
        }
    if (layers.grain)
        for (const std::vector<Vec2>& line : grainLines(piece.grain))
            drawing.line(line, false);
    if (layers.labels)
        drawing.label(piece.label);
    if (layers.sew) {
        drawing.pen(sewingInk, 0.2, Qt::DashLine);
        drawing.line(piece.sew, true);
    }
    drawing.pen(ink, 0.3);
    if (layers.notches)
        for (const CutNotch& notch : piece.notches)
            for (const std::vector<Vec2>& line : notchLines(notch))
                drawing.line(line, false);
    if (layers.cut)
        drawing.line(piece.cut, true);
}

} // namespace bolster
