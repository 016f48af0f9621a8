#include "CoverBuilder.h"

#include <atomic>
#include <random>

namespace bolster::test {

namespace {

std::vector<std::uint32_t> outlineFirst(int columns, int rows)
{
    std::vector<std::uint32_t> number(static_cast<std::size_t>((columns + 1) * (rows + 1)), UINT32_MAX);
    std::uint32_t next = 0;
    const auto give = [&](int i, int j) {
        std::uint32_t& n = number[static_cast<std::size_t>(j * (columns + 1) + i)];
        if (n == UINT32_MAX)
            n = next++;
    };
    for (int i = 0; i < columns; ++i)
        give(i, 0);
    for (int j = 0; j < rows; ++j)
        give(columns, j);
    for (int i = columns; i > 0; --i)
        give(i, rows);
    for (int j = rows; j > 0; --j)
        give(0, j);
    for (int j = 1; j < rows; ++j)
        for (int i = 1; i < columns; ++i)
            give(i, j);
    return number;
}

} // namespace

std::size_t CoverBuilder::grid(const Vec2& size, int columns, int rows, const Bend& bend, double jitter)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(-jitter, jitter);
    const auto first = static_cast<std::uint32_t>(m_positions.size());
    Grid grid{columns, rows, first, outlineFirst(columns, rows)};
    const std::size_t count = grid.at.size();
    m_positions.resize(first + count);
    m_topology.pattern.resize(first + count);
    for (std::uint32_t& v : grid.at)
        v += first;
    const Vec2 cell(size.x() / columns, size.y() / rows);
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            Vec2 p(cell.x() * i, cell.y() * j);
            if (i > 0 && i < columns && j > 0 && j < rows)
                p += Vec2(anywhere(random) * cell.x(), anywhere(random) * cell.y());
            const std::uint32_t v = grid.at[static_cast<std::size_t>(j * (columns + 1) + i)];
            m_topology.pattern[v] = p;
            m_positions[v] = bend(p);
        }
    const auto firstTriangle = static_cast<std::uint32_t>(m_topology.triangles.size());
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const auto at = [&](int x, int y) { return grid.at[static_cast<std::size_t>(y * (columns + 1) + x)]; };
            m_topology.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            m_topology.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    m_topology.patches.push_back({ElementId{10 + static_cast<int>(m_grids.size())}, ElementId{1}, first,
                                  static_cast<std::uint32_t>(count), firstTriangle,
                                  static_cast<std::uint32_t>(2 * columns * rows),
                                  static_cast<std::uint32_t>(2 * (columns + rows))});
    for (std::uint32_t v = first; v < first + count; ++v)
        m_joined.push_back(v);
    m_grids.push_back(std::move(grid));
    return m_grids.size() - 1;
}

std::vector<std::uint32_t> CoverBuilder::side(std::size_t patch, Side side) const
{
    const Grid& grid = m_grids[patch];
    const auto at = [&](int x, int y) { return grid.at[static_cast<std::size_t>(y * (grid.columns + 1) + x)]; };
    std::vector<std::uint32_t> run;
    if (side == Side::Left || side == Side::Right)
        for (int j = 0; j <= grid.rows; ++j)
            run.push_back(at(side == Side::Left ? 0 : grid.columns, j));
    else
        for (int i = 0; i <= grid.columns; ++i)
            run.push_back(at(i, side == Side::Bottom ? 0 : grid.rows));
    return run;
}

void CoverBuilder::sew(std::vector<std::uint32_t> a, std::vector<std::uint32_t> b, Continuity continuity)
{
    for (std::size_t k = 0; k < a.size(); ++k) {
        const std::uint32_t from = m_joined[b[k]], to = m_joined[a[k]];
        for (std::uint32_t& joined : m_joined)
            if (joined == from)
                joined = to;
    }
    m_topology.seams.push_back(
        {ElementId{100 + static_cast<int>(m_topology.seams.size())}, std::move(a), std::move(b), continuity});
}

void CoverBuilder::line(std::size_t patch, int column, bool crease)
{
    const Grid& grid = m_grids[patch];
    SurfaceTopology::Line line{ElementId{200}, {}, 0, crease};
    for (int j = 0; j <= grid.rows; ++j)
        line.vertices.push_back(grid.at[static_cast<std::size_t>(j * (grid.columns + 1) + column)]);
    m_topology.lines.push_back(std::move(line));
}

SurfaceMeshPtr CoverBuilder::cover() const
{
    static std::atomic<std::uint64_t> serial{1000};
    auto topology = std::make_shared<SurfaceTopology>(m_topology);
    topology->serial = ++serial;
    topology->unknown.resize(m_joined.size());
    std::vector<std::uint32_t> number(m_joined.size(), UINT32_MAX);
    for (std::size_t v = 0; v < m_joined.size(); ++v) {
        std::uint32_t& n = number[m_joined[v]];
        if (n == UINT32_MAX)
            n = topology->unknownCount++;
        topology->unknown[v] = n;
    }
    auto mesh = std::make_shared<SurfaceMesh>();
    mesh->positions = m_positions;
    mesh->normals.assign(m_positions.size(), Eigen::Vector3f::UnitZ());
    mesh->topology = std::move(topology);
    return mesh;
}

} // namespace bolster::test
