#include "PatternPdf.h"

#include "PieceDrawing.h"

#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>

#include <cmath>

namespace bolster {

namespace {

constexpr double margin = 10;  // mm: what printers cannot reach
constexpr double overlap = 10; // mm: of neighbours
constexpr double footer = 9;   // mm: words below
constexpr double square = 100, inch = 25.4;
constexpr int dotsPerInch = 1200;

const QColor faint(150, 150, 150);

QSizeF turned(const QSizeF& size, bool landscape)
{
    return landscape ? size.transposed() : size;
}

} // namespace

Box2 SheetGrid::part(int row, int column) const
{
    const double left = column * step.width(), top = table.y() - row * step.height();
    return {Vec2(left, top - room.height()), Vec2(left + room.width(), top)};
}

SheetGrid sheetGrid(const Vec2& table, const PaperSize& paper, bool landscape)
{
    SheetGrid grid;
    grid.table = table;
    grid.paper = paper.roll ? QSizeF(paper.size.width(), std::max(table.y() + 2 * margin + footer, 150.0))
                            : turned(paper.size, landscape);
    grid.room = QRectF(QPointF(margin, margin), grid.paper - QSizeF(2 * margin, 2 * margin + footer));
    grid.step = grid.room.size() - QSizeF(overlap, overlap);
    const auto count = [](double whole, double room, double step) {
        return whole <= room + 1e-6 ? 1 : 1 + static_cast<int>(std::ceil((whole - room) / step - 1e-9));
    };
    grid.columns = count(table.x(), grid.room.width(), grid.step.width());
    grid.rows = paper.roll ? 1 : count(table.y(), grid.room.height(), grid.step.height());
    return grid;
}

double tableWidth(const PaperSize& paper, bool landscape)
{
    const double room = turned(paper.size, landscape && !paper.roll).width() - 2 * margin;
    if (paper.roll)
        return room;
    const double step = room - overlap;
    return room + std::floor(std::max(0.0, 1500 - room) / step) * step; // about what a table takes
}

class PatternPdf::Pages {
public:
    explicit Pages(const PatternPdf& pdf)
        : m_pdf(pdf)
    {}

    bool isEmpty(int row, int column) const
    {
        const Box2 part = m_pdf.m_grid.part(row, column);
        for (const TablePiece& place : m_pdf.m_table.pieces) {
            const CutPiece& piece = m_pdf.m_pattern.pieces[place.piece];
            Box2 box;
            for (const auto* line : {&piece.cut, &piece.sew})
                for (const LinePoint& point : *line)
                    box.extend(place.at(point.at));
            if (part.intersects(box))
                return false;
        }
        return true;
    }

    int count() const
    {
        const SheetGrid& grid = m_pdf.m_grid;
        int pages = 0;
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column)
                pages += !isEmpty(row, column);
        return pages + hasOverview();
    }

    bool hasOverview() const { return m_pdf.m_grid.rows * m_pdf.m_grid.columns > 1; }

    QByteArray draw()
    {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        const SheetGrid& grid = m_pdf.m_grid;
        {
            QPdfWriter writer(&buffer);
            writer.setCreator(QStringLiteral("Bolster"));
            writer.setTitle(QString::fromStdString(m_pdf.m_pattern.style));
            writer.setResolution(dotsPerInch);
            writer.setPageSize(QPageSize(grid.paper, QPageSize::Millimeter, QString(), QPageSize::ExactMatch));
            writer.setPageMargins({});
            QPainter painter(&writer);
            m_painter = &painter;
            painter.scale(dotsPerInch / inch, dotsPerInch / inch); // mm from the upper left corner
            bool first = true;
            const auto newPage = [&] {
                if (!first)
                    writer.newPage();
                first = false;
            };
            if (hasOverview()) {
                newPage();
                overview();
            }
            for (int row = 0; row < grid.rows; ++row)
                for (int column = 0; column < grid.columns; ++column)
                    if (!isEmpty(row, column)) {
                        newPage();
                        sheet(row, column);
                    }
        }
        return bytes;
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

    void squares(const QPointF& corner)
    {
        pen(faint, 0.1);
        m_painter->drawRect(QRectF(corner, QSizeF(square, square)));
        m_painter->drawRect(QRectF(corner, QSizeF(inch, inch)));
        text(QRectF(corner + QPointF(1, square - 5), QSizeF(square - 2, 4)), 2.5, Qt::AlignLeft, tr("100 mm"));
        text(QRectF(corner + QPointF(1, inch - 5), QSizeF(inch - 2, 4)), 2.5, Qt::AlignLeft, tr("1 inch"));
    }

    void words(const QString& place)
    {
        const SheetGrid& grid = m_pdf.m_grid;
        const QRectF strip(grid.room.left(), grid.room.bottom() + 1, grid.room.width(), footer - 2);
        m_painter->setPen(Qt::black);
        text(strip, 3, Qt::AlignLeft | Qt::AlignVCenter, article());
        text(strip, 3, Qt::AlignRight | Qt::AlignVCenter,
             place.isEmpty() ? tr("Print at 100 %") : tr("%1 \u2013 print at 100 %").arg(place));
    }

    QString placeName(int row, int column) const
    {
        return tr("Row %1, column %2 of %3 x %4")
            .arg(row + 1)
            .arg(column + 1)
            .arg(m_pdf.m_grid.rows)
            .arg(m_pdf.m_grid.columns);
    }

    /// Half a diamond in the middle of each edge that has a neighbour: both halves make one.
    void marks(int row, int column)
    {
        const SheetGrid& grid = m_pdf.m_grid;
        const QRectF& room = grid.room;
        const double half = overlap / 2;
        const auto cross = [&](const QPointF& at, const QString& name) {
            pen(Qt::black, 0.2);
            m_painter->drawLine(at - QPointF(4, 0), at + QPointF(4, 0));
            m_painter->drawLine(at - QPointF(0, 4), at + QPointF(0, 4));
            m_painter->drawEllipse(at, 2, 2);
            text(QRectF(at + QPointF(1.5, -5), QSizeF(20, 3)), 2.5, Qt::AlignLeft, name);
        };
        // Names of the edges between sheets are the same on both.
        const auto beside = [&](int r, int left) { return QStringLiteral("%1-%2").arg(r + 1).arg(left + 1); };
        const auto below = [&](int above, int c) { return QStringLiteral("%1/%2").arg(above + 1).arg(c + 1); };
        if (column > 0)
            cross({room.left() + half, room.center().y()}, beside(row, column - 1));
        if (column + 1 < grid.columns)
            cross({room.right() - half, room.center().y()}, beside(row, column));
        if (row > 0)
            cross({room.center().x(), room.top() + half}, below(row - 1, column));
        if (row + 1 < grid.rows)
            cross({room.center().x(), room.bottom() - half}, below(row, column));
        pen(faint, 0.15, Qt::DotLine);
        m_painter->drawRect(room);
    }

    void pieces(double thickness = 1)
    {
        for (const TablePiece& place : m_pdf.m_table.pieces)
            drawPiece(*m_painter, m_pdf.m_pattern.pieces[place.piece], place, m_pdf.m_order.layers, thickness);
    }

    void sheet(int row, int column)
    {
        const SheetGrid& grid = m_pdf.m_grid;
        const Box2 part = grid.part(row, column);
        squares(grid.room.bottomLeft() + QPointF(overlap + 5, -overlap - 5 - square));
        marks(row, column);
        words(hasOverview() ? placeName(row, column) : QString());
        m_painter->save();
        m_painter->setClipRect(grid.room);
        m_painter->translate(grid.room.left() - part.min().x(), grid.room.bottom() + part.min().y());
        m_painter->scale(1, -1);
        pieces();
        m_painter->restore();
    }

    void overview()
    {
        const SheetGrid& grid = m_pdf.m_grid;
        squares(grid.room.bottomLeft() + QPointF(overlap + 5, -overlap - 5 - square));
        words(tr("Overview of %1 x %2 sheets").arg(grid.rows).arg(grid.columns));
        const Vec2 whole((grid.columns - 1) * grid.step.width() + grid.room.width(),
                         (grid.rows - 1) * grid.step.height() + grid.room.height());
        const double scale = std::min(grid.room.width() / whole.x(), grid.room.height() / whole.y());
        m_painter->save();
        m_painter->translate(grid.room.topLeft());
        m_painter->scale(scale, scale);
        m_painter->save();
        m_painter->translate(0, grid.table.y());
        m_painter->scale(1, -1);
        pieces(1 / scale);
        m_painter->restore();
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column) {
                const QRectF where(column * grid.step.width(), row * grid.step.height(), grid.room.width(),
                                   grid.room.height());
                pen(faint, 0.2 / scale, Qt::DashLine);
                m_painter->drawRect(where);
                if (!isEmpty(row, column))
                    text(where, 5 / scale, Qt::AlignCenter, QStringLiteral("%1/%2").arg(row + 1).arg(column + 1));
            }
        m_painter->restore();
    }

    const PatternPdf& m_pdf;
    QPainter* m_painter = nullptr;
};

PatternPdf::PatternPdf(const CutPattern& pattern, const PdfOrder& order)
    : m_pattern(pattern)
    , m_order(order)
    , m_table(arranged(pattern, tableWidth(order.paper, order.landscape)))
    , m_grid(sheetGrid(m_table.size, order.paper, order.landscape))
{}

QByteArray PatternPdf::bytes() const
{
    return Pages(*this).draw();
}

int PatternPdf::pages() const
{
    return Pages(*this).count();
}

} // namespace bolster
