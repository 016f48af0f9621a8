// How often a closed body winds around voxels, counted where rows of them pass through its triangles.
#pragma once

#include "TriangleTree.h"
#include "VoxelGrid.h"

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace bolster {

/// Exact, where solid angles are sums of many: a row that passes through an edge or a corner counts as if it passed
/// beside it, on the same side for all triangles there. For that, corners are taken to a millionth of a millimetre.
class RowCrossings {
public:
    /// The voxels of `grid` from `begin` to `end`. Of a body within 1e7 mm of the origin. When stopped it means
    /// nothing.
    RowCrossings(const std::vector<TriangleTree::Triangle>& triangles, const VoxelGrid& grid,
                 const std::array<int, 3>& begin, const std::array<int, 3>& end, const std::stop_token& stop = {});

    /// Of all rows of a layer, from the first to the last one in y: the steps of the winding number. For each row
    /// one more than it has voxels: the number of a voxel is the sum of the steps behind it in x. For any layer at
    /// any time, from several threads.
    std::vector<int> layer(int z) const;
    std::size_t stepsOfRow() const { return static_cast<std::size_t>(m_end[0] - m_begin[0]) + 1; }

private:
    struct Corner {
        double x = 0;              ///< mm
        std::int64_t y = 0, z = 0; ///< millionths of a millimetre, roughly
    };
    using Corners = std::array<Corner, 3>;

    void addRow(const Corners& corners, int y, std::int64_t z, std::vector<int>& steps) const;
    std::span<const std::uint32_t> ofLayer(int z) const;

    const VoxelGrid& m_grid;
    std::array<int, 3> m_begin, m_end;
    std::vector<Corners> m_triangles;
    std::vector<std::uint32_t> m_first; ///< of each layer, and of one more, in the next
    std::vector<std::uint32_t> m_inLayer;
};

} // namespace bolster
