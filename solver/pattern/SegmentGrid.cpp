#include "SegmentGrid.h"

namespace bolster {

SegmentGrid::SegmentGrid(const Box2& box, double cell)
    : m_box(box)
    , m_cell(cell)
{
    m_columns = static_cast<int>(m_box.sizes().x() / cell) + 1;
    m_rows = static_cast<int>(m_box.sizes().y() / cell) + 1;
    m_cells.resize(static_cast<std::size_t>(m_columns) * m_rows);
}

void SegmentGrid::add(const Vec2& a, const Vec2& b)
{
    const auto [c0, r0] = cellOf(a.cwiseMin(b));
    const auto [c1, r1] = cellOf(a.cwiseMax(b));
    for (int r = r0; r <= r1; ++r)
        for (int c = c0; c <= c1; ++c)
            m_cells[static_cast<std::size_t>(r) * m_columns + c].push_back(static_cast<int>(m_segments.size()));
    m_segments.push_back({a, b});
}

void SegmentGrid::addPolyline(const std::vector<Vec2>& points, bool closed)
{
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        add(points[i], points[i + 1]);
    if (closed && !points.empty())
        add(points.back(), points.front());
}

std::pair<int, int> SegmentGrid::cellOf(const Vec2& p) const
{
    const Vec2 q = (p - m_box.min()) / m_cell;
    return {std::clamp(static_cast<int>(q.x()), 0, m_columns - 1),
            std::clamp(static_cast<int>(q.y()), 0, m_rows - 1)};
}

double SegmentGrid::squaredDistance(const Vec2& p, int segment) const
{
    const auto& [a, b] = m_segments[segment];
    const Vec2 edge = b - a;
    const double length = edge.squaredNorm();
    const double t = length > 0 ? std::clamp((p - a).dot(edge) / length, 0.0, 1.0) : 0;
    return (a + t * edge - p).squaredNorm();
}

} // namespace bolster
