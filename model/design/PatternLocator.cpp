#include "PatternLocator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

PatternLocator::PatternLocator(const SurfaceTopology& topology, const SurfaceTopology::PatchRange& patch)
    : m_topology(topology)
{
    for (std::uint32_t v = patch.firstVertex; v < patch.firstVertex + patch.vertexCount; ++v)
        m_box.extend(topology.pattern[v]);
    const double triangleArea = m_box.sizes().prod() / std::max(1u, patch.triangleCount);
    m_cell = std::max(1e-6, 2 * std::sqrt(triangleArea));
    m_columns = 1 + static_cast<int>(m_box.sizes().x() / m_cell);
    m_rows = 1 + static_cast<int>(m_box.sizes().y() / m_cell);
    m_cells.resize(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows));
    for (std::uint32_t t = patch.firstTriangle; t < patch.firstTriangle + patch.triangleCount; ++t) {
        Box2 box;
        for (const std::uint32_t v : topology.triangles[t])
            box.extend(topology.pattern[v]);
        const auto [c0, r0] = cellOf(box.min());
        const auto [c1, r1] = cellOf(box.max());
        for (int r = r0; r <= r1; ++r)
            for (int c = c0; c <= c1; ++c)
                m_cells[static_cast<std::size_t>(r) * static_cast<std::size_t>(m_columns) +
                        static_cast<std::size_t>(c)]
                    .push_back(t);
    }
}

/// Rings of cells around the point, until one has a triangle and the next cannot have a nearer one.
PatternPlace PatternLocator::locate(const Vec2& point) const
{
    const Vec2 p =
        point.cwiseMax(m_box.min()).cwiseMin(m_box.max()); // no search through all cells for what is far off
    PatternPlace best;
    double bestDistance = std::numeric_limits<double>::max();
    const auto [c, r] = cellOf(p);
    const int rings = std::max(m_columns, m_rows);
    const auto inside = [&](int column, int row) {
        return column >= 0 && row >= 0 && column < m_columns && row < m_rows;
    };
    const double found = 1e-20 * m_cell * m_cell; // no nearer one is possible, but for rounding
    for (int ring = 0; ring <= rings && bestDistance > std::max(found, std::pow((ring - 1) * m_cell, 2)); ++ring)
        for (int row = r - ring; row <= r + ring; ++row)
            for (int column = c - ring; column <= c + ring; ++column)
                if (std::max(std::abs(row - r), std::abs(column - c)) == ring && inside(column, row))
                    for (const std::uint32_t t : cell(column, row))
                        tryTriangle(t, p, best, bestDistance);
    return best;
}

std::pair<int, int> PatternLocator::cellOf(const Vec2& p) const
{
    const Vec2 q = (p - m_box.min()) / m_cell;
    return {static_cast<int>(std::clamp(q.x(), 0.0, m_columns - 1.0)),
            static_cast<int>(std::clamp(q.y(), 0.0, m_rows - 1.0))};
}

const std::vector<std::uint32_t>& PatternLocator::cell(int column, int row) const
{
    return m_cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) +
                   static_cast<std::size_t>(column)];
}

void PatternLocator::tryTriangle(std::uint32_t triangle, const Vec2& p, PatternPlace& best,
                                 double& bestDistance) const
{
    const auto& corners = m_topology.triangles[triangle];
    const Vec2 &a = m_topology.pattern[corners[0]], &b = m_topology.pattern[corners[1]],
               &c = m_topology.pattern[corners[2]];
    const double area = cross(b - a, c - a);
    Eigen::Vector3d weights(cross(b - p, c - p) / area, cross(c - p, a - p) / area, 0);
    weights[2] = 1 - weights[0] - weights[1];
    weights = weights.cwiseMax(0.0);
    weights /= weights.sum();
    const double distance = (weights[0] * a + weights[1] * b + weights[2] * c - p).squaredNorm();
    if (distance < bestDistance) {
        bestDistance = distance;
        best = {corners, weights};
    }
}

} // namespace bolster
