#include "SheetPlan.h"

#include "SheetLayout.h"
#include "SquarePlace.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace bolster {

namespace {

constexpr double halfOverlap = sheetOverlap / 2;

/// A closed line on the table, y down.
std::vector<Vec2> onTable(const std::vector<LinePoint>& line, const TablePiece& place, const CutTable& table)
{
    std::vector<Vec2> points;
    for (const LinePoint& point : line) {
        const Vec2 at = place.at(point.at);
        points.emplace_back(at.x(), table.size.y() - at.y());
    }
    return points;
}

/// Which sheets of a span a piece needs. Every place belongs to one sheet: between neighbours the border lies in
/// the middle of what they have in common.
class NeededSheets {
public:
    NeededSheets(const SheetGrid& grid, const SheetSpan& span)
        : m_grid(grid)
        , m_span(span)
    {}

    void add(const std::vector<Vec2>& line)
    {
        for (std::size_t i = 0; i < line.size(); ++i)
            addSegment(line[i], line[(i + 1) % line.size()]);
        if (m_span.count() > 4) // smaller spans have no sheet without a line
            addInside(line);
    }

    const std::set<std::pair<int, int>>& cells() const { return m_cells; }

private:
    int columnOf(double x) const { return sheetOf(x, m_grid.step.width(), m_span.left, m_span.right); }
    int rowOf(double y) const { return sheetOf(y, m_grid.step.height(), m_span.top, m_span.bottom); }
    static int sheetOf(double at, double step, int first, int last)
    {
        return static_cast<int>(std::clamp(std::floor((at - halfOverlap) / step), static_cast<double>(first),
                                           static_cast<double>(last)));
    }

    /// Where a coordinate crosses borders between sheets, as shares of the way.
    static void addCrossings(std::vector<double>& shares, double from, double to, int first, int last, double step)
    {
        for (int k = std::min(first, last) + 1; k <= std::max(first, last); ++k)
            shares.push_back((k * step + halfOverlap - from) / (to - from));
    }

    void addSegment(const Vec2& a, const Vec2& b)
    {
        std::vector<double> shares{0, 1};
        addCrossings(shares, a.x(), b.x(), columnOf(a.x()), columnOf(b.x()), m_grid.step.width());
        addCrossings(shares, a.y(), b.y(), rowOf(a.y()), rowOf(b.y()), m_grid.step.height());
        std::ranges::sort(shares);
        for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
            const Vec2 middle = a + (shares[i] + shares[i + 1]) / 2 * (b - a);
            m_cells.emplace(rowOf(middle.y()), columnOf(middle.x()));
        }
    }

    /// Sheets that no line touches lie inside or outside as a whole: their middles say.
    void addInside(const std::vector<Vec2>& line)
    {
        for (int row = m_span.top; row <= m_span.bottom; ++row) {
            const double y = (row + 0.5) * m_grid.step.height() + halfOverlap;
            std::vector<double> crossings;
            for (std::size_t i = 0; i < line.size(); ++i) {
                const Vec2 &a = line[i], &b = line[(i + 1) % line.size()];
                if ((a.y() > y) != (b.y() > y))
                    crossings.push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
            }
            std::ranges::sort(crossings);
            std::size_t before = 0;
            for (int column = m_span.left; column <= m_span.right; ++column) {
                const double x = (column + 0.5) * m_grid.step.width() + halfOverlap;
                while (before < crossings.size() && crossings[before] <= x)
                    ++before;
                if (before % 2 == 1)
                    m_cells.emplace(row, column);
            }
        }
    }

    const SheetGrid& m_grid;
    const SheetSpan& m_span;
    std::set<std::pair<int, int>> m_cells;
};

class Planner {
public:
    Planner(const CutPattern& pattern, SheetPlan& plan)
        : m_pattern(pattern)
        , m_plan(plan)
    {}

    void run(const std::stop_token& stop)
    {
        constexpr double bounded = 20 * SheetPlan::mostSheets; // of boxes, whose sheets may be shared or empty
        for (const TablePiece& place : m_plan.table.pieces) {
            m_plan.spans.push_back(m_plan.grid.spanOf(boxOf(place)));
            if (const double count = m_plan.spans.back().count(); count > 4)
                m_plan.wanted += count;
        }
        if (m_plan.wanted > bounded)
            return;
        for (std::size_t i = 0; i < m_plan.table.pieces.size() && !stop.stop_requested(); ++i)
            need(i, m_plan.spans[i]);
        m_plan.wanted = static_cast<double>(m_sheets.size());
        if (m_plan.tooMany())
            return;
        for (auto& [cell, sheet] : m_sheets)
            m_plan.sheets.push_back(std::move(sheet));
        countUsed();
    }

private:
    QRectF boxOf(const TablePiece& place) const
    {
        const Box2 box = turnedBox(m_pattern.pieces[place.piece], place.angle);
        const Vec2 low = box.min() + place.offset, size = box.sizes();
        return {low.x(), m_plan.table.size.y() - low.y() - size.y(), size.x(), size.y()};
    }

    /// Nobody shall look for a row or a column of sheets on which nothing lies.
    void countUsed()
    {
        SheetGrid& grid = m_plan.grid;
        if (m_plan.sheets.empty())
            return;
        grid.rows = grid.columns = 0;
        for (const Sheet& sheet : m_plan.sheets) {
            grid.rows = std::max(grid.rows, sheet.row + 1);
            grid.columns = std::max(grid.columns, sheet.column + 1);
        }
    }

    void need(std::size_t index, const SheetSpan& span)
    {
        const TablePiece& place = m_plan.table.pieces[index];
        const CutPiece& piece = m_pattern.pieces[place.piece];
        NeededSheets needed(m_plan.grid, span);
        needed.add(onTable(piece.cut, place, m_plan.table));
        needed.add(onTable(piece.sew, place, m_plan.table));
        for (const auto& [row, column] : needed.cells()) {
            Sheet& sheet = m_sheets[{row, column}];
            sheet.row = row;
            sheet.column = column;
            sheet.pieces.push_back(index);
            sheet.left |= needed.cells().contains({row, column - 1});
            sheet.right |= needed.cells().contains({row, column + 1});
            sheet.above |= needed.cells().contains({row - 1, column});
            sheet.below |= needed.cells().contains({row + 1, column});
        }
    }

    const CutPattern& m_pattern;
    SheetPlan& m_plan;
    std::map<std::pair<int, int>, Sheet> m_sheets; // by row and column
};

/// A roll is a little longer then.
SheetPlan withRoomForSquare(const CutPattern& pattern, CutTable table, const PdfOrder& order,
                            const std::stop_token& stop)
{
    const Vec2 more(0, testSquare + 4 * sheetOverlap);
    for (TablePiece& place : table.pieces)
        place.offset += more;
    SheetPlan plan;
    plan.table = std::move(table);
    plan.table.size += more;
    plan.grid = sheetGrid(plan.table.size, order.paper, order.landscape);
    Planner(pattern, plan).run(stop);
    return plan;
}

} // namespace

SheetPlan planSheets(const CutPattern& pattern, const PdfOrder& order, const std::stop_token& stop)
{
    SheetPlan plan;
    plan.table = arrangedOnSheets(pattern, order.paper, order.landscape, stop);
    plan.grid = sheetGrid(plan.table.size, order.paper, order.landscape);
    Planner(pattern, plan).run(stop);
    const bool longer = order.paper.roll && plan.sheets.size() == 1 && !stop.stop_requested() &&
                        !squarePlace(pattern, plan, plan.sheets.front(), order.layers).free;
    return longer ? withRoomForSquare(pattern, plan.table, order, stop) : plan;
}

} // namespace bolster
