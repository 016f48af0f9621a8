#include "SheetGrid.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double unprinted = 10;                         // mm: what printers cannot reach
constexpr double mostBeside = 1e8;                       // sheets: more cannot be counted
constexpr double longestPage = 5000, shortestPage = 150; // mm, of a roll

QSizeF asItLies(const PaperSize& paper, bool landscape)
{
    return landscape && !paper.roll ? paper.size.transposed() : paper.size;
}

int sheetsFor(double whole, double room, double step)
{
    return whole <= room + 1e-6
               ? 1
               : 1 + static_cast<int>(std::min(mostBeside, std::ceil((whole - room) / step - 1e-9)));
}

} // namespace

Box2 SheetGrid::part(int row, int column) const
{
    const double left = column * step.width(), top = table.y() - row * step.height();
    return {Vec2(left, top - room.height()), Vec2(left + room.width(), top)};
}

SheetSpan SheetGrid::spanOf(const QRectF& box) const
{
    constexpr double line = 1; // mm: a line on the border of a sheet could not be seen
    const auto first = [](double at, double one) {
        return static_cast<int>(std::clamp(std::floor((at - line) / one), 0.0, mostBeside));
    };
    const auto last = [](double at, double whole, double one, int least) {
        return std::max(least, static_cast<int>(std::clamp(std::ceil((at + line - whole) / one), 0.0, mostBeside)));
    };
    SheetSpan span;
    span.left = first(box.left(), step.width());
    span.right = last(box.right(), room.width(), step.width(), span.left);
    span.top = first(box.top(), step.height());
    span.bottom = last(box.bottom(), room.height(), step.height(), span.top);
    return span;
}

QSizeF SheetGrid::whole() const
{
    return {(columns - 1) * step.width() + room.width(), (rows - 1) * step.height() + room.height()};
}

SheetGrid sheetGrid(const Vec2& table, const PaperSize& paper, bool landscape)
{
    SheetGrid grid;
    grid.table = table;
    grid.paper = asItLies(paper, landscape);
    if (paper.roll) {
        constexpr double point = 25.4 / 72; // pages of PDF have a whole number of these
        const double needed = std::clamp(table.y() + 2 * unprinted + sheetFooter, shortestPage, longestPage);
        grid.paper.setHeight(std::ceil(needed / point) * point);
    }
    grid.room =
        QRectF(QPointF(unprinted, unprinted), grid.paper - QSizeF(2 * unprinted, 2 * unprinted + sheetFooter));
    grid.step = grid.room.size() - QSizeF(sheetOverlap, sheetOverlap);
    grid.columns = sheetsFor(table.x(), grid.room.width(), grid.step.width());
    grid.rows = sheetsFor(table.y(), grid.room.height(), grid.step.height());
    return grid;
}

double tableWidth(const PaperSize& paper, bool landscape)
{
    constexpr double table = 1500; // mm: about what people have
    const double room = asItLies(paper, landscape).width() - 2 * unprinted;
    if (paper.roll)
        return room;
    const double step = room - sheetOverlap;
    return room + std::floor(std::max(0.0, table - room) / step) * step;
}

} // namespace bolster
