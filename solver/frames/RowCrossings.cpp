#include "RowCrossings.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bolster {

namespace {

constexpr double perMillimetre = 1 << 20;

std::int64_t exact(double millimetres)
{
    return std::llround(millimetres * perMillimetre);
}

/// A product of two differences.
__extension__ using Wide = __int128;

struct Place {
    std::int64_t y = 0, z = 0;
};

/// Twice the area of a triangle: positive when `p` lies to the left of the way from `u` to `v`. Where it lies on
/// it, the sign is that of a place a little farther in y, and far less farther in z: 1 or -1. 0 where there is no
/// way.
Wide sideOf(const Place& u, const Place& v, const Place& p)
{
    const Wide area = static_cast<Wide>(v.y - u.y) * (p.z - u.z) - static_cast<Wide>(v.z - u.z) * (p.y - u.y);
    if (area != 0)
        return area;
    if (v.z != u.z)
        return v.z < u.z ? 1 : -1;
    return v.y > u.y ? 1 : v.y < u.y ? -1 : 0;
}

/// The whole numbers of which (number + 1/2) edge lies between both, from `low`.
std::pair<int, int> centresBetween(std::int64_t from, std::int64_t to, double edge, int low)
{
    // One more on either side, for rounding: each of them is looked at exactly.
    const double first = static_cast<double>(from) / perMillimetre / edge - low - 0.5;
    const double last = static_cast<double>(to) / perMillimetre / edge - low - 0.5;
    return {static_cast<int>(std::ceil(first)) - 1, static_cast<int>(std::floor(last)) + 2};
}

} // namespace

RowCrossings::RowCrossings(const std::vector<TriangleTree::Triangle>& triangles, const VoxelGrid& grid,
                           const std::array<int, 3>& begin, const std::array<int, 3>& end,
                           const std::stop_token& stop)
    : m_grid(grid)
    , m_begin(begin)
    , m_end(end)
    , m_first(static_cast<std::size_t>(end[2] - begin[2]) + 1, 0)
{
    std::vector<std::pair<int, int>> layers;
    for (const TriangleTree::Triangle& triangle : triangles) {
        Corners corners;
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = {triangle[k].x(), exact(triangle[k].y()), exact(triangle[k].z())};
        const auto [low, high] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
        auto [first, last] = centresBetween(low, high, grid.edge, grid.low[2]);
        first = std::max(first, begin[2]);
        last = std::min(last, end[2]);
        if (first >= last)
            continue;
        m_triangles.push_back(corners);
        layers.emplace_back(first, last);
        for (int z = first; z < last; ++z)
            ++m_first[static_cast<std::size_t>(z - begin[2])];
    }
    std::exclusive_scan(m_first.begin(), m_first.end(), m_first.begin(), 0U);
    m_inLayer.resize(m_first.back());
    std::vector<std::uint32_t> next = m_first;
    for (std::uint32_t t = 0; t < layers.size() && !stop.stop_requested(); ++t)
        for (int z = layers[t].first; z < layers[t].second; ++z)
            m_inLayer[next[static_cast<std::size_t>(z - begin[2])]++] = t;
}

std::span<const std::uint32_t> RowCrossings::ofLayer(int z) const
{
    const auto layer = static_cast<std::size_t>(z - m_begin[2]);
    return std::span(m_inLayer).subspan(m_first[layer], m_first[layer + 1] - m_first[layer]);
}

std::vector<int> RowCrossings::layer(int z) const
{
    std::vector<int> steps(stepsOfRow() * static_cast<std::size_t>(m_end[1] - m_begin[1]), 0);
    const std::int64_t height = exact(m_grid.centre(0, 0, z).z());
    for (const std::uint32_t triangle : ofLayer(z)) {
        const Corners& corners = m_triangles[triangle];
        const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
        const auto [first, last] = centresBetween(low, high, m_grid.edge, m_grid.low[1]);
        for (int y = std::max(first, m_begin[1]); y < std::min(last, m_end[1]); ++y)
            addRow(corners, y, height, steps);
    }
    return steps;
}

void RowCrossings::addRow(const Corners& corners, int y, std::int64_t z, std::vector<int>& steps) const
{
    const Place p{exact(m_grid.centre(0, y, 0).y()), z};
    std::array<Wide, 3> sides{}; // of the edge that lies opposite of each corner
    int left = 0, right = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Corner &u = corners[(k + 1) % 3], &v = corners[(k + 2) % 3];
        sides[k] = sideOf({u.y, u.z}, {v.y, v.z}, p);
        left += sides[k] > 0 ? 1 : 0;
        right += sides[k] < 0 ? 1 : 0;
    }
    if (left != 3 && right != 3)
        return;
    double sum = 0, weighted = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto weight = static_cast<double>(sides[k]);
        sum += weight;
        weighted += weight * corners[k].x;
    }
    const double at =
        weighted / sum / m_grid.edge - m_grid.low[0] - 0.5; // of this many voxels the centres lie before
    const int voxels =
        static_cast<int>(std::clamp(std::ceil(at), static_cast<double>(m_begin[0]), static_cast<double>(m_end[0])));
    steps[stepsOfRow() * static_cast<std::size_t>(y - m_begin[1]) +
          static_cast<std::size_t>(voxels - m_begin[0])] += left == 3 ? 1 : -1;
}

} // namespace bolster
