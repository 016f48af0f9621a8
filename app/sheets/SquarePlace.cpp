#include "SquarePlace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bolster {

namespace {

constexpr double aroundSquare = 3; // mm that stay free
constexpr double aroundMark = 12;  // mm: half of what a mark between sheets takes
constexpr double finestRaster = 2; // mm
constexpr double mostFields = 4e5; // of a raster

/// Counts of fields in rectangles, each in no time.
class FieldCounts {
public:
    FieldCounts(int columns, int rows)
        : m_columns(columns)
        , m_rows(rows)
        , m_fields(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows))
    {}

    void set(int x, int y) { m_fields[index(x, y)] = 1; }
    /// After the last set().
    void sumUp()
    {
        for (int y = 0; y < m_rows; ++y)
            for (int x = 0; x < m_columns; ++x)
                m_fields[index(x, y)] += at(x - 1, y) + at(x, y - 1) - at(x - 1, y - 1);
    }
    int count(int x, int y, int size) const
    {
        const int right = x + size - 1, below = y + size - 1;
        return at(right, below) - at(x - 1, below) - at(right, y - 1) + at(x - 1, y - 1);
    }

private:
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_columns) + static_cast<std::size_t>(x);
    }
    int at(int x, int y) const { return x < 0 || y < 0 ? 0 : m_fields[index(x, y)]; }

    int m_columns, m_rows;
    std::vector<int> m_fields;
};

/// A part of a sheet in small squares: which have a line, and which lie on a piece.
class SheetRaster {
public:
    explicit SheetRaster(const QRectF& area)
        : m_area(area)
        , m_field(std::max(finestRaster, std::sqrt(area.width() * area.height() / mostFields)))
        , m_columns(std::max(1, static_cast<int>(area.width() / m_field)))
        , m_rows(std::max(1, static_cast<int>(area.height() / m_field)))
        , m_lines(m_columns, m_rows)
        , m_pieces(m_columns, m_rows)
    {}

    void addLine(const QPointF& a, const QPointF& b)
    {
        const QPointF from = inFields(a), way = inFields(b) - from;
        const auto [first, last] = partInside(from, way);
        if (first > last)
            return;
        const double length = std::hypot(way.x(), way.y()) * (last - first);
        const int steps = 1 + static_cast<int>(2 * length);
        for (int k = 0; k <= steps; ++k) {
            const QPointF at = from + (first + (last - first) * k / steps) * way;
            m_lines.set(std::clamp(static_cast<int>(at.x()), 0, m_columns - 1),
                        std::clamp(static_cast<int>(at.y()), 0, m_rows - 1));
        }
    }

    void addBox(const QRectF& box)
    {
        const QRectF whole(0, 0, m_columns, m_rows);
        const QRectF fields = QRectF(inFields(box.topLeft()), inFields(box.bottomRight())).intersected(whole);
        for (int y = static_cast<int>(fields.top()); y < fields.bottom(); ++y)
            for (int x = static_cast<int>(fields.left()); x < fields.right(); ++x)
                m_lines.set(x, y);
    }

    /// Everything inside of a closed line.
    void addArea(const std::vector<QPointF>& line)
    {
        std::vector<std::vector<double>> crossings(static_cast<std::size_t>(m_rows));
        for (std::size_t i = 0; i < line.size(); ++i) {
            const QPointF a = inFields(line[i]), b = inFields(line[(i + 1) % line.size()]);
            const double low = std::min(a.y(), b.y()), high = std::max(a.y(), b.y());
            for (int y = std::max(0, static_cast<int>(std::ceil(std::clamp(low - 0.5, -1.0, m_rows + 1.0))));
                 y < m_rows && y + 0.5 < high; ++y)
                if (y + 0.5 >= low)
                    crossings[static_cast<std::size_t>(y)].push_back(a.x() + (b.x() - a.x()) * (y + 0.5 - a.y()) /
                                                                                 (b.y() - a.y()));
        }
        for (int y = 0; y < m_rows; ++y) {
            std::vector<double>& row = crossings[static_cast<std::size_t>(y)];
            std::ranges::sort(row);
            for (std::size_t k = 0; k + 1 < row.size(); k += 2)
                for (int x = static_cast<int>(std::clamp(row[k], 0.0, static_cast<double>(m_columns)));
                     x < m_columns && x < row[k + 1]; ++x)
                    m_pieces.set(x, y);
        }
    }

    /// Where a square meets the fewest lines, then the least of pieces: the lowest such place, the leftmost of
    /// these.
    SquarePlace best(double side)
    {
        m_lines.sumUp();
        m_pieces.sumUp();
        const int size = static_cast<int>(std::ceil((side + 2 * aroundSquare) / m_field));
        std::pair<int, int> least(std::numeric_limits<int>::max(), 0);
        SquarePlace place{m_area.topLeft() + QPointF(aroundSquare, aroundSquare), false};
        for (int y = m_rows - size; y >= 0; --y)
            for (int x = 0; x + size <= m_columns; ++x) {
                const std::pair cost(m_lines.count(x, y, size), m_pieces.count(x, y, size));
                if (!(cost < least))
                    continue;
                least = cost;
                place.corner = m_area.topLeft() + QPointF(x, y) * m_field + QPointF(aroundSquare, aroundSquare);
                place.free = cost == std::pair(0, 0);
            }
        return place;
    }

private:
    QPointF inFields(const QPointF& at) const { return (at - m_area.topLeft()) / m_field; }

    /// The shares of a way between which it lies inside; the first is larger when it does nowhere.
    std::pair<double, double> partInside(const QPointF& from, const QPointF& way) const
    {
        double first = 0, last = 1;
        const auto clip = [&](double at, double along, double most) {
            if (std::abs(along) < 1e-12) {
                if (at < 0 || at > most)
                    last = -1;
                return;
            }
            const double a = -at / along, b = (most - at) / along;
            first = std::max(first, std::min(a, b));
            last = std::min(last, std::max(a, b));
        };
        clip(from.x(), way.x(), m_columns);
        clip(from.y(), way.y(), m_rows);
        return {first, last};
    }

    QRectF m_area;
    double m_field;
    int m_columns, m_rows;
    FieldCounts m_lines, m_pieces;
};

/// Of one sheet all that is drawn.
class SheetInk {
public:
    SheetInk(SheetRaster& raster, const SheetPlan& plan, const Sheet& sheet)
        : m_raster(raster)
        , m_room(plan.grid.room)
        , m_part(plan.grid.part(sheet.row, sheet.column))
    {}

    void add(const CutPiece& piece, const TablePiece& place, const CutLayers& layers)
    {
        m_place = &place;
        const std::vector<QPointF> cut = onPaper(piece.cut);
        m_raster.addArea(cut);
        if (layers.cut)
            lines(cut, true);
        if (layers.sew)
            lines(onPaper(piece.sew), true);
        if (layers.internal)
            for (const PieceLine& inner : piece.inner)
                lines(onPaper(inner.points), inner.closed);
        if (layers.notches)
            for (const CutNotch& notch : piece.notches)
                for (const std::vector<Vec2>& line : notchLines(notch))
                    for (std::size_t i = 0; i + 1 < line.size(); ++i)
                        m_raster.addLine(onPaper(line[i]), onPaper(line[i + 1]));
        if (layers.holes)
            for (const CutHole& hole : piece.holes)
                box(hole.at, Vec2(hole.diameter / 2 + 2, hole.diameter / 2 + 2), 0);
        if (layers.grain)
            m_raster.addLine(onPaper(piece.grain.from), onPaper(piece.grain.to));
        if (layers.labels)
            box(piece.label.at,
                Vec2(piece.label.width, piece.label.height * static_cast<double>(piece.label.lines.size())) / 2,
                piece.label.rotation * std::numbers::pi / 180);
    }

private:
    QPointF onPaper(const Vec2& point) const
    {
        const Vec2 at = m_place->at(point);
        return {m_room.left() + at.x() - m_part.min().x(), m_room.bottom() - (at.y() - m_part.min().y())};
    }
    std::vector<QPointF> onPaper(const std::vector<LinePoint>& line) const
    {
        std::vector<QPointF> points;
        for (const LinePoint& point : line)
            points.push_back(onPaper(point.at));
        return points;
    }
    void lines(const std::vector<QPointF>& points, bool closed)
    {
        for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i)
            m_raster.addLine(points[i], points[(i + 1) % points.size()]);
    }
    /// With half its sides, turned.
    void box(const Vec2& middle, const Vec2& half, double turn)
    {
        const Eigen::Rotation2Dd turned(turn);
        QRectF all(onPaper(middle), QSizeF(0, 0));
        for (const double x : {-1.0, 1.0})
            for (const double y : {-1.0, 1.0}) {
                const QPointF corner = onPaper(middle + turned * Vec2(x * half.x(), y * half.y()));
                all.setLeft(std::min(all.left(), corner.x()));
                all.setRight(std::max(all.right(), corner.x()));
                all.setTop(std::min(all.top(), corner.y()));
                all.setBottom(std::max(all.bottom(), corner.y()));
            }
        m_raster.addBox(all);
    }

    SheetRaster& m_raster;
    QRectF m_room;
    Box2 m_part;
    const TablePiece* m_place = nullptr;
};

} // namespace

SquarePlace squarePlace(const CutPattern& pattern, const SheetPlan& plan, const Sheet& sheet,
                        const CutLayers& layers)
{
    // Neighbours lie over the border.
    const QRectF area = plan.grid.room.adjusted(sheetOverlap, sheetOverlap, -sheetOverlap, -sheetOverlap);
    SheetRaster raster(area);
    SheetInk ink(raster, plan, sheet);
    for (const std::size_t index : sheet.pieces) {
        const TablePiece& place = plan.table.pieces[index];
        ink.add(pattern.pieces[place.piece], place, layers);
    }
    const QRectF& room = plan.grid.room;
    const std::pair<bool, QPointF> marks[] = {{sheet.left, {room.left(), room.center().y()}},
                                              {sheet.right, {room.right(), room.center().y()}},
                                              {sheet.above, {room.center().x(), room.top()}},
                                              {sheet.below, {room.center().x(), room.bottom()}}};
    for (const auto& [isThere, at] : marks)
        if (isThere)
            raster.addBox(QRectF(at - QPointF(aroundMark, aroundMark), QSizeF(2 * aroundMark, 2 * aroundMark)));
    return raster.best(testSquare);
}

} // namespace bolster
