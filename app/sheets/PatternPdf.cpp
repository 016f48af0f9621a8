#include "PatternPdf.h"

#include "PieceDrawing.h"
#include "PieceLayout.h"
#include "SquarePlace.h"

#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace bolster {

namespace {

constexpr double oneInch = 25.4; // mm
constexpr int dotsPerInch = 1200;
constexpr double besideOverview = 10; // mm: from the picture of all sheets to the square
constexpr double listLine = 4.5;      // mm, of the list of pieces

const QColor faint(150, 150, 150);

} // namespace

/// Draws on the pages of one file; mm from the upper left corner of the paper.
class PatternPdf::Pages {
public:
    explicit Pages(const PatternPdf& pdf)
        : m_pdf(pdf)
        , m_grid(pdf.m_plan.grid)
    {}

    /// False when it was stopped.
    bool draw(QIODevice& device, const SheetWatch& watch)
    {
        QPdfWriter writer(&device);
        writer.setCreator(QStringLiteral("Bolster"));
        writer.setTitle(QString::fromStdString(m_pdf.m_pattern.style));
        writer.setResolution(dotsPerInch);
        writer.setPageSize(QPageSize(m_grid.paper, QPageSize::Millimeter, QString(), QPageSize::ExactMatch));
        writer.setPageMargins({});
        QPainter painter(&writer);
        m_painter = &painter;
        painter.scale(dotsPerInch / oneInch, dotsPerInch / oneInch);
        const SheetPlan& plan = m_pdf.m_plan;
        if (plan.hasOverview())
            overview();
        for (std::size_t i = 0; i < plan.sheets.size(); ++i) {
            if (watch.stopped())
                return false;
            watch.say(static_cast<double>(i) / static_cast<double>(plan.sheets.size()));
            if (i > 0 || plan.hasOverview())
                writer.newPage();
            sheet(plan.sheets[i]);
        }
        return !watch.stopped();
    }

private:
    void pen(const QColor& color, double width, Qt::PenStyle style = Qt::SolidLine)
    {
        m_painter->setPen(QPen(color, width, style, Qt::FlatCap, Qt::MiterJoin));
        m_painter->setBrush(Qt::NoBrush);
    }

    void text(const QRectF& where, double height, int flags, const QString& words)
    {
        m_painter->save();
        constexpr double pixels = 100;
        const double scale = height / pixels;
        m_painter->translate(where.topLeft());
        m_painter->scale(scale, scale);
        QFont font(QStringLiteral("DejaVu Sans"));
        font.setStyleHint(QFont::SansSerif);
        font.setPixelSize(static_cast<int>(pixels));
        m_painter->setFont(font);
        m_painter->drawText(QRectF(QPointF(), where.size() / scale), flags, words);
        m_painter->restore();
    }

    QString article() const
    {
        return QString::fromStdString(m_pdf.m_pattern.style + " " + m_pdf.m_pattern.version).trimmed();
    }

    /// Over a piece only their corners, so that nobody takes them for its lines.
    void squares(const SquarePlace& place)
    {
        const QPointF corner = place.corner;
        pen(faint, 0.1);
        for (const double size : {testSquare, oneInch}) {
            const QRectF square(corner, QSizeF(size, size));
            place.free ? m_painter->drawRect(square) : cornersOf(square);
        }
        text(QRectF(corner + QPointF(1, testSquare - 5), QSizeF(testSquare - 2, 4)), 2.5, Qt::AlignLeft,
             tr("100 mm: to measure, no part of the pattern"));
        text(QRectF(corner + QPointF(1, oneInch - 5), QSizeF(oneInch - 2, 4)), 2.5, Qt::AlignLeft, tr("1 inch"));
    }

    void cornersOf(const QRectF& square)
    {
        constexpr double arm = 4;
        for (const double x : {square.left(), square.right()})
            for (const double y : {square.top(), square.bottom()}) {
                const QPointF at(x, y);
                m_painter->drawLine(at, at + QPointF(x == square.left() ? arm : -arm, 0));
                m_painter->drawLine(at, at + QPointF(0, y == square.top() ? arm : -arm));
            }
    }

    void words(const QString& place)
    {
        const QRectF& room = m_grid.room;
        const QRectF strip(room.left(), room.bottom() + 1, room.width(), sheetFooter - 2);
        m_painter->setPen(Qt::black);
        text(strip, 3, Qt::AlignLeft | Qt::AlignVCenter, article());
        text(strip, 3, Qt::AlignRight | Qt::AlignVCenter,
             place.isEmpty() ? tr("Print at 100 %") : tr("%1 \u2013 print at 100 %").arg(place));
    }

    QString placeName(const Sheet& sheet) const
    {
        return tr("Sheet %1 (row %2 of %3, column %4 of %5)")
            .arg(shortName(sheet.row, sheet.column))
            .arg(sheet.row + 1)
            .arg(m_grid.rows)
            .arg(sheet.column + 1)
            .arg(m_grid.columns);
    }
    static QString shortName(int row, int column) { return QStringLiteral("%1/%2").arg(row + 1).arg(column + 1); }

    /// A cross in the middle of each edge that has a neighbour: those of both meet.
    void marks(const Sheet& sheet)
    {
        const QRectF& room = m_grid.room;
        const double half = sheetOverlap / 2;
        // Not like a drill hole, which has a circle. The same two sheets are named on both.
        const auto cross = [&](const QPointF& at, int row, int column, bool atRight) {
            pen(Qt::black, 0.2);
            m_painter->drawLine(at - QPointF(4, 0), at + QPointF(4, 0));
            m_painter->drawLine(at - QPointF(0, 4), at + QPointF(0, 4));
            m_painter->drawPolygon(QPolygonF(
                {at - QPointF(2.5, 0), at - QPointF(0, 2.5), at + QPointF(2.5, 0), at + QPointF(0, 2.5)}));
            const QString here = shortName(sheet.row, sheet.column), there = shortName(row, column);
            const bool first = std::pair(sheet.row, sheet.column) < std::pair(row, column);
            text(QRectF(at + QPointF(atRight ? -42 : 2, -5.5), QSizeF(40, 3)), 2.5,
                 atRight ? Qt::AlignRight : Qt::AlignLeft,
                 QStringLiteral("%1 + %2").arg(first ? here : there, first ? there : here));
        };
        if (sheet.left)
            cross({room.left() + half, room.center().y()}, sheet.row, sheet.column - 1, false);
        if (sheet.right)
            cross({room.right() - half, room.center().y()}, sheet.row, sheet.column + 1, true);
        if (sheet.above)
            cross({room.center().x(), room.top() + half}, sheet.row - 1, sheet.column, false);
        if (sheet.below)
            cross({room.center().x(), room.bottom() - half}, sheet.row + 1, sheet.column, false);
        pen(faint, 0.15, Qt::DotLine);
        m_painter->drawRect(room);
    }

    void piece(std::size_t index, double thickness = 1)
    {
        const TablePiece& place = m_pdf.m_plan.table.pieces[index];
        drawPiece(*m_painter, m_pdf.m_pattern.pieces[place.piece], place, m_pdf.m_order.layers, thickness);
    }

    void sheet(const Sheet& sheet)
    {
        const Box2 part = m_grid.part(sheet.row, sheet.column);
        squares(squarePlace(m_pdf.m_pattern, m_pdf.m_plan, sheet, m_pdf.m_order.layers));
        marks(sheet);
        words(m_pdf.m_plan.hasOverview() ? placeName(sheet) : QString());
        m_painter->save();
        m_painter->setClipRect(m_grid.room);
        m_painter->translate(m_grid.room.left() - part.min().x(), m_grid.room.bottom() + part.min().y());
        m_painter->scale(1, -1);
        for (const std::size_t index : sheet.pieces)
            piece(index);
        m_painter->restore();
    }

    /// All sheets above or beside the square, and which piece is on which.
    void overview()
    {
        const QRectF& room = m_grid.room;
        const bool wide = room.width() > room.height();
        const double kept = testSquare + besideOverview;
        const QRectF all = wide ? room.adjusted(0, 0, -kept, 0) : room.adjusted(0, 0, 0, -kept);
        const QPointF corner = wide ? QPointF(room.right() - testSquare, room.bottom() - testSquare)
                                    : QPointF(room.left(), room.bottom() - testSquare);
        squares({corner, true});
        words(tr("Overview of %1 x %2 sheets").arg(m_grid.rows).arg(m_grid.columns));
        const QSizeF whole = m_grid.whole();
        const double scale = std::min(all.width() / whole.width(), all.height() / whole.height());
        m_painter->save();
        m_painter->translate(all.topLeft());
        m_painter->scale(scale, scale);
        overviewPicture(scale);
        m_painter->restore();
        list(wide ? QRectF(corner.x(), room.top(), testSquare, corner.y() - besideOverview - room.top())
                  : QRectF(room.left() + kept, corner.y(), room.width() - kept, testSquare));
    }

    void overviewPicture(double scale)
    {
        m_painter->save();
        m_painter->translate(0, m_grid.table.y());
        m_painter->scale(1, -1);
        for (std::size_t index = 0; index < m_pdf.m_plan.table.pieces.size(); ++index)
            piece(index, 1 / scale);
        m_painter->restore();
        for (const Sheet& sheet : m_pdf.m_plan.sheets) {
            const QRectF where(QPointF(sheet.column * m_grid.step.width(), sheet.row * m_grid.step.height()),
                               m_grid.room.size());
            pen(faint, 0.2 / scale, Qt::DashLine);
            m_painter->drawRect(where);
            m_painter->setPen(Qt::black);
            text(where.adjusted(2 / scale, 2 / scale, 0, 0), 3 / scale, Qt::AlignLeft | Qt::AlignTop,
                 shortName(sheet.row, sheet.column));
        }
    }

    void list(const QRectF& where)
    {
        m_painter->setPen(Qt::black);
        const SheetPlan& plan = m_pdf.m_plan;
        const auto most = static_cast<std::size_t>(std::max(0.0, std::floor(where.height() / listLine)));
        QRectF line(where.topLeft(), QSizeF(where.width(), listLine));
        for (std::size_t i = 0; i < std::min(most, plan.table.pieces.size()); ++i) {
            const bool more = i + 1 == most && plan.table.pieces.size() > most;
            const SheetSpan& span = plan.spans[i];
            const QString name =
                QString::fromStdString(m_pdf.m_pattern.pieces[plan.table.pieces[i].piece].name).left(40);
            const QString first = shortName(span.top, span.left), last = shortName(span.bottom, span.right);
            text(line, 2.8, Qt::AlignLeft | Qt::AlignVCenter,
                 more            ? QStringLiteral("\u2026")
                 : first == last ? tr("%1: sheet %2").arg(name, first)
                                 : tr("%1: sheets %2 to %3").arg(name, first, last));
            line.translate(0, listLine);
        }
    }

    const PatternPdf& m_pdf;
    const SheetGrid& m_grid;
    QPainter* m_painter = nullptr;
};

PatternPdf::PatternPdf(const CutPattern& pattern, const PdfOrder& order, const std::stop_token& stop)
    : m_pattern(pattern)
    , m_order(order)
    , m_plan(planSheets(pattern, order, stop))
{
    if (order.layers.labels && !stop.stop_requested())
        keepLabelsOnSheets();
}

/// Who cuts along the border of a sheet, or lays two sheets side by side, still reads them.
void PatternPdf::keepLabelsOnSheets()
{
    std::map<std::size_t, std::vector<const Sheet*>> sheetsOf;
    for (const Sheet& sheet : m_plan.sheets)
        for (const std::size_t index : sheet.pieces)
            sheetsOf[index].push_back(&sheet);
    for (const auto& [index, sheets] : sheetsOf) {
        const TablePiece& place = m_plan.table.pieces[index];
        CutPiece& piece = m_pattern.pieces[place.piece];
        if (sheets.size() < 2 || piece.label.byHand || !piece.label.fits || piece.label.lines.empty())
            continue;
        std::vector<std::pair<Vec2, Vec2>> borders;
        for (const Sheet* const sheet : sheets) {
            const Box2 part = m_plan.grid.part(sheet->row, sheet->column);
            const auto corner = [&](Box2::CornerType type) {
                return Vec2(Eigen::Rotation2Dd(-place.angle) * (part.corner(type) - place.offset));
            };
            const Vec2 a = corner(Box2::BottomLeft), b = corner(Box2::BottomRight), c = corner(Box2::TopRight),
                       d = corner(Box2::TopLeft);
            borders.insert(borders.end(), {{a, b}, {b, c}, {c, d}, {d, a}});
        }
        const Vec2 up = piece.grain.to - piece.grain.from;
        const double grain = up.norm() > 0 ? std::atan2(up.y(), up.x()) * 180 / std::numbers::pi : 90;
        PieceLabel label = placeLabel(piece, piece.label.lines, grain, borders);
        if (label.fits)
            piece.label = std::move(label);
    }
}

QByteArray PatternPdf::bytes(const SheetWatch& watch) const
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    const bool whole = !m_plan.tooMany() && Pages(*this).draw(buffer, watch);
    buffer.close();
    return whole ? bytes : QByteArray();
}

} // namespace bolster
