#include "SheetLayout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <tuple>

namespace bolster {

namespace {

constexpr double fromSheetBorder = 5;       // mm, of pieces
constexpr double betweenPieces = 10;        // mm
constexpr std::size_t placedTogether = 100; // pieces: the time grows with the square of this
constexpr double uncountable = 20000;       // sheets of one piece: whoever has that mistook a unit

struct Turn {
    double angle = 0;
    Box2 box; ///< of the piece, turned

    QSizeF size() const { return {box.sizes().x(), box.sizes().y()}; }
};

/// As it lies with its grain upright, turned by 90 degrees, and askew where that saves sheets.
struct Shape {
    std::size_t piece = 0;
    std::vector<Turn> turns;

    QSizeF size() const { return turns.front().size(); }
};

double sheetsAlone(const SheetGrid& grid, const QSizeF& size)
{
    return grid.spanOf({QPointF(fromSheetBorder, fromSheetBorder), size}).count();
}

/// What would stand a few millimetres beyond a row of sheets is turned until it does not.
void addAskew(Shape& shape, const CutPiece& piece, const SheetGrid& grid)
{
    constexpr int steps = 36; // of a half turn
    double fewest = std::min(sheetsAlone(grid, shape.turns[0].size()), sheetsAlone(grid, shape.turns[1].size()));
    std::optional<Turn> best;
    for (int k = 1; k < steps && fewest > 1; ++k) {
        const double angle = shape.turns.front().angle + std::numbers::pi * k / steps;
        const Turn turn{angle, turnedBox(piece, angle)};
        if (const double sheets = sheetsAlone(grid, turn.size()); sheets < fewest) {
            fewest = sheets;
            best = turn;
        }
    }
    if (best)
        shape.turns.push_back(*best);
}

std::vector<Shape> shapesOf(const CutPattern& pattern, const SheetGrid& grid, const std::stop_token& stop)
{
    std::vector<Shape> shapes;
    for (std::size_t i = 0; i < pattern.pieces.size() && !stop.stop_requested(); ++i) {
        const double upright = uprightAngle(pattern.pieces[i]);
        Shape shape{i, {}};
        for (const double angle : {upright, upright + std::numbers::pi / 2})
            shape.turns.push_back({angle, turnedBox(pattern.pieces[i], angle)});
        if (shape.turns.front().box.isEmpty())
            continue;
        if (sheetsAlone(grid, shape.size()) <= uncountable)
            addAskew(shape, pattern.pieces[i], grid);
        shapes.push_back(std::move(shape));
    }
    return shapes;
}

/// Sheets by row and column.
using SheetSet = std::set<std::pair<int, int>>;

/// Where y runs down from the upper edge of the table.
class Packing {
public:
    Packing(const SheetGrid& grid, double width)
        : m_grid(grid)
        , m_width(width)
        , m_columns(static_cast<int>(std::max(1.0, std::floor(width / grid.step.width()))))
    {}

    /// Where it costs the fewest new sheets, then where it lies on the fewest, then as far up as possible.
    void add(const Shape& shape)
    {
        m_best = {};
        for (std::size_t turn = 0; turn < shape.turns.size(); ++turn)
            if (turn == 0 || shape.turns[turn].size().width() + 2 * fromSheetBorder <= m_width)
                tryAll(shape, turn);
        m_taken.push_back(m_best.box);
        m_placed.push_back({shape.piece, shape.turns[m_best.turn].angle, shape.turns[m_best.turn].box.min()});
        use(m_grid.spanOf(m_best.box));
    }

    /// Nothing is placed above what is there now.
    void beginBelow()
    {
        double bottom = 0;
        for (const QRectF& box : m_taken)
            bottom = std::max(bottom, box.bottom());
        m_firstRow = m_taken.empty() ? 0 : static_cast<int>(std::floor(bottom / m_grid.step.height())) + 1;
        m_lastRow = m_firstRow;
        m_from = m_taken.size();
    }

    CutTable table() const
    {
        CutTable table;
        for (const QRectF& box : m_taken)
            table.size = table.size.cwiseMax(Vec2(box.right() + fromSheetBorder, box.bottom() + fromSheetBorder));
        for (std::size_t i = 0; i < m_placed.size(); ++i) {
            const Vec2 corner(m_taken[i].left(), table.size.y() - m_taken[i].bottom());
            table.pieces.push_back({m_placed[i].piece, m_placed[i].angle, corner - m_placed[i].corner});
        }
        return table;
    }

    double sheets() const { return m_sheets; }

private:
    struct Placed {
        std::size_t piece;
        double angle;
        Vec2 corner; ///< of its turned box
    };
    struct Best {
        std::tuple<double, double, std::size_t, double, double> cost{std::numeric_limits<double>::infinity(), 0, 0,
                                                                     0, 0};
        std::size_t turn = 0;
        QRectF box;
    };

    double columnAt(int column) const { return column * m_grid.step.width() + fromSheetBorder; }
    double rowAt(int row) const { return row * m_grid.step.height() + fromSheetBorder; }

    /// Beside and below what is there, and at the beginnings of sheets.
    void tryAll(const Shape& shape, std::size_t turn)
    {
        const auto look = [&](double x, double y) { tryAt({QPointF(x, y), shape.turns[turn].size()}, turn); };
        for (int row = m_firstRow; row <= m_lastRow; ++row)
            for (int column = 0; column < m_columns; ++column)
                look(columnAt(column), rowAt(row));
        for (std::size_t i = m_from; i < m_taken.size(); ++i) {
            const QRectF& other = m_taken[i];
            look(other.right() + betweenPieces, other.top());
            look(other.left(), other.bottom() + betweenPieces);
            for (int row = m_firstRow; row <= m_lastRow; ++row)
                look(other.right() + betweenPieces, rowAt(row));
            for (int column = 0; column < m_columns; ++column)
                look(columnAt(column), other.bottom() + betweenPieces);
        }
    }

    void tryAt(const QRectF& box, std::size_t turn)
    {
        const bool tooWide = box.right() + fromSheetBorder > m_width + 1e-6 && box.left() > fromSheetBorder;
        if (tooWide)
            return;
        const SheetSpan span = m_grid.spanOf(box);
        const auto cost = std::tuple(newSheets(span), span.count(), turn, box.top(), box.left());
        if (!(cost < m_best.cost))
            return;
        const double apart = betweenPieces - 1e-6;
        const QRectF around = box.adjusted(-apart, -apart, apart, apart);
        for (std::size_t i = m_from; i < m_taken.size(); ++i)
            if (around.intersects(m_taken[i]))
                return;
        m_best = {cost, turn, box};
    }

    double newSheets(const SheetSpan& span) const
    {
        if (span.count() > uncountable)
            return span.count();
        double count = 0;
        for (int row = span.top; row <= span.bottom; ++row)
            for (int column = span.left; column <= span.right; ++column)
                count += !m_used.contains({row, column});
        return count;
    }

    void use(const SheetSpan& span)
    {
        m_lastRow = std::max(m_lastRow, span.bottom + 1);
        m_sheets += newSheets(span);
        if (span.count() <= uncountable)
            for (int row = span.top; row <= span.bottom; ++row)
                for (int column = span.left; column <= span.right; ++column)
                    m_used.emplace(row, column);
    }

    const SheetGrid& m_grid;
    double m_width;
    int m_columns;
    int m_firstRow = 0, m_lastRow = 0;
    std::size_t m_from = 0;
    std::vector<QRectF> m_taken;
    std::vector<Placed> m_placed;
    SheetSet m_used;
    double m_sheets = 0;
    Best m_best;
};

/// How many sheets a table takes, going by the boxes of its pieces.
double sheetsOf(const CutPattern& pattern, const CutTable& table, const SheetGrid& grid)
{
    SheetSet used;
    double more = 0;
    for (const TablePiece& place : table.pieces) {
        const Box2 box = turnedBox(pattern.pieces[place.piece], place.angle);
        const Vec2 corner = box.min() + place.offset, size = box.sizes();
        const SheetSpan span =
            grid.spanOf({corner.x(), table.size.y() - corner.y() - size.y(), size.x(), size.y()});
        if (span.count() > uncountable) {
            more += span.count();
            continue;
        }
        for (int row = span.top; row <= span.bottom; ++row)
            for (int column = span.left; column <= span.right; ++column)
                used.emplace(row, column);
    }
    return more + static_cast<double>(used.size());
}

} // namespace

CutTable arrangedOnSheets(const CutPattern& pattern, const PaperSize& paper, bool landscape,
                          const std::stop_token& stop)
{
    CutTable inRows = arranged(pattern, tableWidth(paper, landscape));
    if (paper.roll)
        return inRows;
    const SheetGrid grid = sheetGrid(Vec2(1, 1), paper, landscape);
    std::vector<Shape> shapes = shapesOf(pattern, grid, stop);
    double width = tableWidth(paper, landscape);
    for (const Shape& shape : shapes)
        width = std::max(width, shape.size().width() + 2 * fromSheetBorder);
    const auto alone = [&](const Shape& shape) { return sheetsAlone(grid, shape.size()); };
    if (std::ranges::any_of(shapes, [&](const Shape& shape) { return alone(shape) > uncountable; }))
        return inRows;
    // Large ones first: small ones find room beside them.
    std::ranges::stable_sort(shapes, std::ranges::greater(),
                             [&](const Shape& shape) { return std::pair(alone(shape), shape.size().height()); });
    Packing packing(grid, width);
    for (std::size_t i = 0; i < shapes.size() && !stop.stop_requested(); ++i) {
        if (i % placedTogether == 0)
            packing.beginBelow();
        packing.add(shapes[i]);
    }
    return packing.sheets() <= sheetsOf(pattern, inRows, sheetGrid(inRows.size, paper, landscape)) ? packing.table()
                                                                                                   : inRows;
}

} // namespace bolster
