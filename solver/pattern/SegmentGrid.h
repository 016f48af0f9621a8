// Line segments in a grid, for questions about what lies near a point of the pattern plane.
#pragma once

#include "Geometry.h"

#include <algorithm>
#include <vector>

namespace bolster {

class SegmentGrid {
public:
    /// `cell` (mm) should be about the length of a segment. All segments must lie in the box.
    SegmentGrid(const Box2& box, double cell);

    /// Its number is the count of those before.
    void add(const Vec2& a, const Vec2& b);
    void addPolyline(const std::vector<Vec2>& points, bool closed);

    bool nearerThan(const Vec2& p, double distance) const
    {
        return anyNear(p, distance, [](int) { return true; });
    }
    /// Whether a segment nearer than `distance` (mm) satisfies wanted(number).
    template <class Wanted>
    bool anyNear(const Vec2& p, double distance, Wanted wanted) const
    {
        const auto [c0, r0] = cellOf(p - Vec2::Constant(distance));
        const auto [c1, r1] = cellOf(p + Vec2::Constant(distance));
        for (int r = r0; r <= r1; ++r)
            for (int c = c0; c <= c1; ++c)
                for (int i : m_cells[static_cast<std::size_t>(r) * m_columns + c])
                    if (squaredDistance(p, i) < distance * distance && wanted(i))
                        return true;
        return false;
    }

private:
    struct Segment {
        Vec2 a, b;
    };

    std::pair<int, int> cellOf(const Vec2& p) const;
    double squaredDistance(const Vec2& p, int segment) const;

    Box2 m_box;
    double m_cell;
    int m_columns = 0, m_rows = 0;
    std::vector<Segment> m_segments;
    std::vector<std::vector<int>> m_cells;
};

} // namespace bolster
