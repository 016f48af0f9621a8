#include "FewerTriangles.h"

#include <cmath>
#include <unordered_map>

namespace bolster {

namespace {

/// Cells of space are numbered by their coordinates, some million along each axis.
std::uint64_t cellKey(std::int64_t x, std::int64_t y, std::int64_t z, unsigned octant)
{
    constexpr std::uint64_t mask = (1U << 20) - 1;
    return (static_cast<std::uint64_t>(x) & mask) | (static_cast<std::uint64_t>(y) & mask) << 20 |
           (static_cast<std::uint64_t>(z) & mask) << 40 | static_cast<std::uint64_t>(octant) << 60;
}

double areaOf(const SurfaceTopology& topology)
{
    double twice = 0;
    for (const auto& [a, b, c] : topology.triangles) {
        const Vec2 u = topology.pattern[b] - topology.pattern[a], v = topology.pattern[c] - topology.pattern[a];
        twice += std::abs(u.x() * v.y() - u.y() * v.x());
    }
    return twice / 2;
}

/// For each vertex the one that stands for it.
std::vector<std::uint32_t> standFor(const SurfaceTopology& topology, double cell)
{
    std::vector<std::uint32_t> kept(topology.vertexCount());
    for (const SurfaceTopology::PatchRange& patch : topology.patches) {
        std::unordered_map<std::uint64_t, std::uint32_t> cells;
        for (std::uint32_t v = patch.firstVertex; v < patch.firstVertex + patch.vertexCount; ++v) {
            const Vec2 at = topology.pattern[v] / cell;
            kept[v] =
                v < patch.firstVertex + patch.outlineCount
                    ? v
                    : cells.try_emplace(cellKey(std::llround(at.x()), std::llround(at.y()), 0, 0), v).first->second;
        }
    }
    return kept;
}

std::uint64_t keyOf(const FrameSkin::Corner& corner, float cell)
{
    const Eigen::Vector3f at = corner.position / cell;
    const unsigned octant =
        (corner.normal.x() > 0 ? 1U : 0U) | (corner.normal.y() > 0 ? 2U : 0U) | (corner.normal.z() > 0 ? 4U : 0U);
    return cellKey(std::llround(at.x()), std::llround(at.y()), std::llround(at.z()), octant);
}

float cellOf(const std::vector<FrameSkin::Corner>& corners, std::size_t most)
{
    double twice = 0;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
        twice += (corners[i + 1].position - corners[i].position)
                     .cross(corners[i + 2].position - corners[i].position)
                     .norm();
    // Some two triangles for each cell that the surface passes.
    return static_cast<float>(std::sqrt(twice / static_cast<double>(most)));
}

} // namespace

FewerTriangles fewerTriangles(const SurfaceTopology& topology, std::size_t most)
{
    // Two triangles for each square.
    const double cell = std::sqrt(2 * areaOf(topology) / static_cast<double>(most));
    const std::vector<std::uint32_t> kept = standFor(topology, cell);
    FewerTriangles fewer;
    for (const SurfaceTopology::PatchRange& patch : topology.patches) {
        fewer.firstOf.push_back(fewer.triangles.size());
        for (std::uint32_t t = patch.firstTriangle; t < patch.firstTriangle + patch.triangleCount; ++t) {
            const auto& [a, b, c] = topology.triangles[t];
            const std::array<std::uint32_t, 3> corners{kept[a], kept[b], kept[c]};
            if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
                fewer.triangles.push_back(corners);
        }
    }
    fewer.firstOf.push_back(fewer.triangles.size());
    return fewer;
}

std::vector<FrameSkin::Corner> fewerCorners(const std::vector<FrameSkin::Corner>& corners, std::size_t most)
{
    const float cell = cellOf(corners, most);
    std::vector<FrameSkin::Corner> fewer;
    if (!(cell > 0))
        return fewer;
    struct Cell {
        FrameSkin::Corner sum;
        int count = 0;
    };
    std::unordered_map<std::uint64_t, std::uint32_t> numbers;
    std::vector<Cell> cells;
    std::vector<std::uint32_t> cellOfCorner(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto [found, fresh] = numbers.try_emplace(keyOf(corners[i], cell), cells.size());
        if (fresh) {
            cells.push_back({corners[i], 1});
        } else {
            Cell& sum = cells[found->second];
            sum.sum.position += corners[i].position;
            sum.sum.normal += corners[i].normal;
            ++sum.count;
        }
        cellOfCorner[i] = found->second;
    }
    for (Cell& sum : cells) {
        sum.sum.position /= static_cast<float>(sum.count);
        sum.sum.normal.normalize();
    }
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const std::uint32_t a = cellOfCorner[i], b = cellOfCorner[i + 1], c = cellOfCorner[i + 2];
        if (a != b && b != c && c != a)
            for (const std::uint32_t corner : {a, b, c})
                fewer.push_back(cells[corner].sum);
    }
    return fewer;
}

} // namespace bolster
