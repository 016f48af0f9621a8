#include "ForceField.h"

#include <algorithm>
#include <cmath>

namespace bolster {

ForceField::ForceField(const VoxelGrid& grid, const std::vector<float>& depths, std::vector<std::uint8_t> owners,
                       WorkerPool& pool, const std::stop_token& stop)
    : m_grid(grid)
    , m_cells(depths.size())
    , m_owners(std::move(owners))
    , m_insideCount(std::count_if(depths.begin(), depths.end(), [](float depth) { return depth > 0; }))
{
    const auto edge = static_cast<float>(grid.edge);
    const float outermost = -1.5F * edge;
    const std::array<std::size_t, 3> strides = {1, grid.index(0, 1, 0), grid.index(0, 0, 1)};
    pool.forTasks(std::max(0, grid.size[2] - 2), [&](int layer) {
        for (int y = 1; y < grid.size[1] - 1 && !stop.stop_requested(); ++y)
            for (int x = 1; x < grid.size[0] - 1; ++x) {
                const std::size_t i = grid.index(x, y, layer + 1);
                if (depths[i] <= outermost)
                    continue;
                Cell& cell = m_cells[i];
                float slope = 0; // squared
                for (int axis = 0; axis < 3; ++axis) {
                    const float ahead = std::max(outermost, depths[i + strides[axis]]);
                    const float behind = std::max(outermost, depths[i - strides[axis]]);
                    const float derivative = (ahead - behind) / (2 * edge);
                    cell.force[axis] = -derivative * depths[i];
                    slope += derivative * derivative;
                }
                constexpr float flattest = 0.1F; // between two surfaces the force vanishes, and no way is meant
                cell.force[3] = std::max(0.0F, depths[i]) / std::max(flattest, std::sqrt(slope));
            }
    });
}

ForceField::Push ForceField::at(const Vec3& point, std::span<const double> strengths) const
{
    std::array<int, 3> cell{};
    std::array<float, 3> share{};
    const double perEdge = 1 / m_grid.edge;
    for (int k = 0; k < 3; ++k) {
        const double place = point[k] * perEdge - m_grid.low[k] - 0.5;
        if (!(place >= 0 && place < m_grid.size[k] - 1))
            return {};
        cell[k] = static_cast<int>(place);
        share[k] = static_cast<float>(place - cell[k]);
    }
    const std::size_t first = m_grid.index(cell[0], cell[1], cell[2]);
    const std::size_t row = static_cast<std::size_t>(m_grid.size[0]);
    const std::size_t layer = row * static_cast<std::size_t>(m_grid.size[1]);
    const bool owned = !m_owners.empty() && !strengths.empty();
    Eigen::Array4f sum = Eigen::Array4f::Zero(); // force, depth
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const std::size_t dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
        const float weight =
            (dx ? share[0] : 1 - share[0]) * (dy ? share[1] : 1 - share[1]) * (dz ? share[2] : 1 - share[2]);
        const std::size_t i = first + dx + dy * row + dz * layer;
        Eigen::Array4f c = Eigen::Map<const Eigen::Array4f>(m_cells[i].force);
        if (owned)
            c.head<3>() *= static_cast<float>(strengths[m_owners[i]]);
        sum += weight * c;
    }
    Push push{sum.matrix().head<3>().cast<double>(), sum[3]};
    if (m_owners.empty() && !strengths.empty())
        push.force *= strengths[0];
    return push;
}

namespace {

/// Calls visit(index in `part`, index in `whole`) for the voxels that two grids have in common.
template <class Visit>
void forCommon(const VoxelGrid& part, const VoxelGrid& whole, const Visit& visit)
{
    std::array<int, 3> begin{}, end{};
    for (int k = 0; k < 3; ++k) {
        begin[k] = std::max(0, whole.low[k] - part.low[k]);
        end[k] = std::min(part.size[k], whole.low[k] + whole.size[k] - part.low[k]);
    }
    for (int z = begin[2]; z < end[2]; ++z)
        for (int y = begin[1]; y < end[1]; ++y)
            for (int x = begin[0]; x < end[0]; ++x)
                visit(part.index(x, y, z),
                      whole.index(x + part.low[0] - whole.low[0], y + part.low[1] - whole.low[1],
                                  z + part.low[2] - whole.low[2]));
}

VoxelGrid widened(const VoxelGrid& grid, int margin)
{
    VoxelGrid wide = grid;
    for (int k = 0; k < 3; ++k) {
        wide.low[k] -= margin;
        wide.size[k] += 2 * margin;
    }
    return wide;
}

void extend(VoxelGrid& grid, const VoxelGrid& other)
{
    for (int k = 0; k < 3; ++k) {
        const int end = std::max(grid.low[k] + grid.size[k], other.low[k] + other.size[k]);
        grid.low[k] = std::min(grid.low[k], other.low[k]);
        grid.size[k] = end - grid.low[k];
    }
}

/// The voxels that touch the surface from outside belong to what they touch.
void ownOutside(const Voxels& voxels, std::vector<std::uint8_t>& owners, const std::stop_token& stop)
{
    const VoxelGrid& grid = voxels.grid;
    const std::array<std::size_t, 3> strides = {1, grid.index(0, 1, 0), grid.index(0, 0, 1)};
    for (int z = 1; z < grid.size[2] - 1 && !stop.stop_requested(); ++z)
        for (int y = 1; y < grid.size[1] - 1; ++y)
            for (int x = 1; x < grid.size[0] - 1; ++x) {
                const std::size_t i = grid.index(x, y, z);
                for (int axis = 0; axis < 3 && !voxels.inside[i]; ++axis)
                    for (const std::size_t neighbour : {i - strides[axis], i + strides[axis]})
                        if (voxels.inside[neighbour])
                            owners[i] = owners[neighbour];
            }
}

} // namespace

Voxels dilated(const Voxels& body, double dilation, WorkerPool& pool, const std::stop_token& stop)
{
    const double steps = dilation / body.grid.edge + 0.5; // rounded: to whole voxels in the directions of the axes
    Voxels wide{widened(body.grid, static_cast<int>(steps) + 1), {}};
    wide.inside.assign(wide.grid.voxelCount(), 0);
    forCommon(body.grid, wide.grid, [&](std::size_t i, std::size_t k) { wide.inside[k] = body.inside[i]; });
    if (steps < 1)
        return wide;
    const std::vector<float> distances = distancesTo(1, wide, VoxelMetric::Euclidean, pool, stop);
    std::transform(distances.begin(), distances.end(), wide.inside.begin(),
                   [&](float distance) { return static_cast<std::uint8_t>(distance <= steps); });
    return wide;
}

std::vector<float> depthsOf(const Voxels& voxels, VoxelMetric metric, WorkerPool& pool, const std::stop_token& stop)
{
    const auto edge = static_cast<float>(voxels.grid.edge);
    std::vector<float> depths = distancesTo(0, voxels, metric, pool, stop);
    const std::vector<float> outside = distancesTo(1, voxels, metric, pool, stop);
    for (std::size_t i = 0; i < depths.size(); ++i)
        depths[i] = edge * (voxels.inside[i] ? depths[i] - 0.5F : 0.5F - outside[i]);
    return depths;
}

std::shared_ptr<const ForceField> cushionField(std::span<const CushionBody> bodies, VoxelMetric metric,
                                               WorkerPool& pool, const std::stop_token& stop)
{
    constexpr int margin = 2; // voxels outside, of which one carries a negative depth
    std::vector<Voxels> thick;
    Voxels all;
    for (const CushionBody& body : bodies) {
        if (stop.stop_requested())
            return nullptr;
        thick.push_back(dilated(*body.voxels, body.dilation, pool, stop));
        if (thick.size() == 1)
            all.grid = thick.back().grid;
        else if (!body.cut)
            extend(all.grid, thick.back().grid);
    }
    all.grid = widened(all.grid, margin);
    all.inside.assign(all.grid.voxelCount(), 0);
    std::vector<std::uint8_t> owners(bodies.size() > 1 ? all.inside.size() : 0);
    for (const bool cut : {false, true})
        for (std::size_t b = 0; b < bodies.size() && !stop.stop_requested(); ++b)
            if (bodies[b].cut == cut)
                forCommon(thick[b].grid, all.grid, [&](std::size_t i, std::size_t k) {
                    if (!thick[b].inside[i])
                        return;
                    all.inside[k] = !cut;
                    if (!cut && !owners.empty())
                        owners[k] = static_cast<std::uint8_t>(b);
                });
    thick.clear();
    if (!owners.empty())
        ownOutside(all, owners, stop);
    const std::vector<float> depths = depthsOf(all, metric, pool, stop);
    if (stop.stop_requested())
        return nullptr;
    auto field = std::make_shared<const ForceField>(all.grid, depths, std::move(owners), pool, stop);
    return stop.stop_requested() ? nullptr : field;
}

} // namespace bolster
