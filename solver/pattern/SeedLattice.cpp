#include "SeedLattice.h"

#include "SegmentGrid.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

/// Edge lengths that seeds keep away from the outline and from lines: more than half of one, so that nothing passes
/// between two neighbours.
constexpr double seedGap = 0.55;
/// What lies in a triangle is nearer than that to one of its corners.
constexpr double reach = 0.6;

/// For each of these heights, increasing: where a horizontal line enters and leaves the outline, increasing.
std::vector<std::vector<double>> crossings(const std::vector<Vec2>& boundary, const std::vector<double>& heights)
{
    std::vector<std::vector<double>> crossings(heights.size());
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        const Vec2& p = boundary[i];
        const Vec2& q = boundary[(i + 1) % boundary.size()];
        const auto [low, high] = std::minmax(p.y(), q.y());
        for (auto y = std::ranges::lower_bound(heights, low); y != heights.end() && *y < high; ++y)
            crossings[y - heights.begin()].push_back(p.x() + (*y - p.y()) / (q.y() - p.y()) * (q.x() - p.x()));
    }
    for (std::vector<double>& xs : crossings)
        std::sort(xs.begin(), xs.end());
    return crossings;
}

} // namespace

SeedLattice::SeedLattice(const std::vector<Vec2>& boundary, const std::vector<InnerLine>& lines, double edgeLength)
{
    Box2 box;
    for (const Vec2& p : boundary)
        box.extend(p);
    SegmentGrid grid(box, edgeLength);
    grid.addPolyline(boundary, true);
    for (const InnerLine& line : lines)
        grid.addPolyline(line.points, line.closed);
    const double height = edgeLength * std::sqrt(3.0) / 2;
    const int rows = static_cast<int>(box.sizes().y() / height);
    const double firstY = box.center().y() - 0.5 * rows * height;
    std::vector<double> heights;
    for (int row = 0; row <= rows; ++row)
        heights.push_back(firstY + row * height);
    const std::vector<std::vector<double>> crossed = crossings(boundary, heights);
    for (int row = 0; row <= rows; ++row)
        addRow(row % 2 == 1, heights[row], box.center().x(), edgeLength, crossed[row], grid);
    findNeighbours();
    countRings();
}

void SeedLattice::addRow(bool shifted, double y, double middle, double edge, const std::vector<double>& crossings,
                         const SegmentGrid& grid)
{
    Row& row = m_rows.emplace_back();
    row.shifted = shifted;
    const double shift = middle + (shifted ? 0.5 * edge : 0);
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        for (double i = std::ceil((crossings[k] - shift) / edge); shift + i * edge < crossings[k + 1]; ++i) {
            const Vec2 p(shift + i * edge, y);
            if (grid.nearerThan(p, seedGap * edge))
                continue;
            const int column = static_cast<int>(i);
            if (row.seeds.empty())
                row.firstColumn = column;
            row.seeds.resize(column - row.firstColumn, -1);
            row.seeds.push_back(static_cast<int>(m_points.size()));
            m_points.push_back(p);
            m_rings.push_back(grid.nearerThan(p, reach * edge) ? -1 : 0);
        }
}

int SeedLattice::Row::at(int column) const
{
    const int k = column - firstColumn;
    return k >= 0 && k < std::ssize(seeds) ? seeds[k] : -1;
}

void SeedLattice::findNeighbours()
{
    static const Row nothing;
    m_neighbours.resize(m_points.size());
    for (std::size_t r = 0; r < m_rows.size(); ++r) {
        const Row& row = m_rows[r];
        const Row& below = r > 0 ? m_rows[r - 1] : nothing;
        const Row& above = r + 1 < m_rows.size() ? m_rows[r + 1] : nothing;
        for (int k = 0; k < std::ssize(row.seeds); ++k) {
            if (row.seeds[k] < 0)
                continue;
            const int column = row.firstColumn + k, right = row.shifted ? column + 1 : column; // in other rows
            m_neighbours[row.seeds[k]] = {row.at(column - 1), row.at(column + 1),  below.at(right - 1),
                                          below.at(right),    above.at(right - 1), above.at(right)};
        }
    }
}

void SeedLattice::countRings()
{
    for (int ring = 1; ring <= insideRings + 1; ++ring)
        for (std::size_t seed = 0; seed < m_points.size(); ++seed)
            if (m_rings[seed] == ring - 1 && std::ranges::all_of(m_neighbours[seed], [&](int n) {
                    return n >= 0 && m_rings[static_cast<std::size_t>(n)] >= ring - 1;
                }))
                m_rings[seed] = static_cast<signed char>(ring);
}

std::vector<std::array<int, 3>> SeedLattice::insideTriangles() const
{
    std::vector<std::array<int, 3>> triangles;
    triangles.reserve(2 * m_points.size());
    const auto inside = [&](int seed) { return isInside(seed); };
    for (int seed = 0; seed < std::ssize(m_points); ++seed) {
        const Neighbours& at = m_neighbours[seed];
        if (!inside(seed) || !inside(at[AboveRight])) // one that is inside has all its neighbours
            continue;
        if (inside(at[Right]))
            triangles.push_back({seed, at[Right], at[AboveRight]});
        if (inside(at[AboveLeft]))
            triangles.push_back({seed, at[AboveRight], at[AboveLeft]});
    }
    return triangles;
}

} // namespace bolster
