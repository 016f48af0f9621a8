#include "SeamDrawing.h"

#include "PieceDrawing.h"
#include "SegmentDistance.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bolster {

namespace {

constexpr double numberRadius = 22;                                // pixels, of the circle around a number
constexpr double aroundNumber = 4;                                 // pixels
constexpr int numberPixels = 28;                                   // height of its figures
constexpr double numberBorder = 2 * (numberRadius + aroundNumber); // pixels: numbers may stand outside
constexpr double endTick = 10;                                     // pixels, where a seam ends

/// From the piece to the picture.
class PictureFrame {
public:
    PictureFrame(const CutPiece& piece, const QSize& pixels)
        : m_place{0, uprightAngle(piece), Vec2::Zero()}
        , m_middle(pixels.width() / 2.0, pixels.height() / 2.0)
    {
        const Box2 box = turnedBox(piece, m_place.angle);
        const Vec2 room(pixels.width() - 2 * numberBorder, pixels.height() - 2 * numberBorder);
        scale = std::max(1e-6, room.cwiseQuotient(box.sizes().cwiseMax(1.0)).minCoeff());
        m_place.offset = -box.center();
    }

    QPointF operator()(const Vec2& point) const
    {
        const Vec2 at = scale * m_place.at(point);
        return m_middle + QPointF(at.x(), -at.y());
    }
    void apply(QPainter& painter) const
    {
        painter.translate(m_middle);
        painter.scale(scale, -scale);
    }
    const TablePiece& place() const { return m_place; }

    double scale = 1; ///< pixels of a millimetre

private:
    TablePiece m_place;
    QPointF m_middle;
};

double distanceTo(const std::vector<QPointF>& line, const QPointF& at)
{
    double nearest = std::numeric_limits<double>::infinity();
    const auto place = [](const QPointF& p) { return Vec2(p.x(), p.y()); };
    for (std::size_t i = 0; i < line.size(); ++i)
        nearest = std::min(nearest, segmentDistance(place(at), place(line[i]), place(line[(i + 1) % line.size()])));
    return nearest;
}

class SeamNumbers {
public:
    SeamNumbers(QPainter& painter, const CutPiece& piece, const PictureFrame& frame)
        : m_painter(painter)
        , m_outline(piece.outline)
        , m_frame(frame)
        , m_bounds(painter.viewport())
        , m_turnsLeft(piece.outline.signedArea() > 0)
    {
        for (const LinePoint& point : piece.sew)
            m_sew.push_back(frame(point.at));
        for (const LinePoint& point : piece.cut)
            m_cut.push_back(frame(point.at));
    }

    void add(const NumberedSide& side)
    {
        const double length =
            unwrappedEnd(side.from, side.to, m_outline.domainStart(), m_outline.domainEnd()) - side.from;
        tick(side.from);
        tick(side.to);
        QPointF best;
        double least = std::numeric_limits<double>::infinity();
        for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9})
            for (const bool inside : {true, false}) {
                const QPointF at = beside(side.from + share * length, inside);
                const double cost = costOf(at, inside) + std::abs(share - 0.5);
                if (cost < least) {
                    least = cost;
                    best = at;
                }
            }
        draw(best, side.number);
    }

private:
    /// Of length 1, in the picture.
    QPointF inwards(double t) const
    {
        const Vec2 at = m_outline.at(m_outline.wrapped(t)), along = m_outline.derivative(m_outline.wrapped(t));
        const QPointF way = m_frame(at + along.normalized()) - m_frame(at);
        const double length = std::hypot(way.x(), way.y());
        if (!(length > 0))
            return {0, 1};
        return (m_turnsLeft ? QPointF(way.y(), -way.x()) : QPointF(-way.y(), way.x())) / length;
    }

    QPointF beside(double t, bool inside) const
    {
        const QPointF at = m_frame(m_outline.at(m_outline.wrapped(t)));
        const double off = numberRadius + aroundNumber;
        return inside ? at + off * inwards(t) : at - (off + std::min(off, distanceTo(m_cut, at))) * inwards(t);
    }

    /// Numbers on each other cannot be read; those on lines are hard to.
    double costOf(const QPointF& at, bool inside) const
    {
        double cost = inside ? 0 : 2;
        for (const QPointF& other : m_numbers) {
            const QPointF off = other - at;
            cost += std::max(0.0, 2 * numberRadius + 2 - std::hypot(off.x(), off.y()));
        }
        cost += 0.2 * std::max(0.0, numberRadius - distanceTo(m_sew, at));
        const double border = numberRadius + 1;
        const bool isShown = m_bounds.adjusted(border, border, -border, -border).contains(at);
        return cost + (isShown ? 0 : 1000);
    }

    void tick(double t)
    {
        const QPointF at = m_frame(m_outline.at(m_outline.wrapped(t))), in = endTick * inwards(t);
        m_painter.setPen(QPen(Qt::black, 3));
        m_painter.drawLine(at - in, at + in);
    }

    void draw(const QPointF& at, int number)
    {
        m_numbers.push_back(at);
        m_painter.setPen(QPen(Qt::black, 2));
        m_painter.setBrush(Qt::white);
        m_painter.drawEllipse(at, numberRadius, numberRadius);
        QFont font(QStringLiteral("DejaVu Sans"));
        font.setStyleHint(QFont::SansSerif);
        font.setPixelSize(number < 100 ? numberPixels : 2 * numberPixels / 3);
        m_painter.setFont(font);
        m_painter.drawText(QRectF(at - QPointF(50, 50), QSizeF(100, 100)), Qt::AlignCenter,
                           QString::number(number));
    }

    QPainter& m_painter;
    const BSpline2& m_outline;
    const PictureFrame& m_frame;
    QRectF m_bounds;
    bool m_turnsLeft;
    std::vector<QPointF> m_sew, m_cut, m_numbers;
};

} // namespace

QSize seamDrawingSize(const CutPiece& piece, const QSize& most)
{
    const int border = static_cast<int>(2 * numberBorder);
    const Box2 box = turnedBox(piece, uprightAngle(piece));
    if (box.isEmpty())
        return {border, border};
    const Vec2 size = box.sizes().cwiseMax(1.0);
    const QSizeF room = most - QSize(border, border);
    return QSizeF(size.x(), size.y()).scaled(room, Qt::KeepAspectRatio).toSize() + QSize(border, border);
}

QImage seamDrawing(const CutPiece& piece, const std::vector<NumberedSide>& sides, const QSize& pixels)
{
    QImage image(pixels, QImage::Format_RGB32);
    image.fill(Qt::white);
    if (piece.box().isEmpty() || piece.outline.empty())
        return image;
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const PictureFrame frame(piece, pixels);
    CutLayers layers;
    layers.labels = false;
    painter.save();
    frame.apply(painter);
    drawPiece(painter, piece, frame.place(), layers, 9 / frame.scale);
    painter.restore();
    SeamNumbers numbers(painter, piece, frame);
    for (const NumberedSide& side : sides)
        numbers.add(side);
    return image;
}

} // namespace bolster
