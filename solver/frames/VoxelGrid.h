// A box of cubes.
#pragma once

#include "Geometry.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace bolster {

/// Voxels are numbered x first, then y, then z. Their faces lie at whole multiples of `edge`, whatever the box, so
/// that grids of the same edge fit together.
struct VoxelGrid {
    double edge = 5;                     ///< mm
    std::array<int, 3> low = {0, 0, 0};  ///< the first voxel's lower corner, in edges
    std::array<int, 3> size = {0, 0, 0}; ///< in voxels

    /// That covers a box, with `margin` voxels around it.
    static VoxelGrid around(const Box3& box, double edge, int margin)
    {
        VoxelGrid grid{edge, {}, {}};
        for (int k = 0; k < 3 && !box.isEmpty(); ++k) {
            grid.low[k] = static_cast<int>(std::floor(box.min()[k] / edge)) - margin;
            grid.size[k] = static_cast<int>(std::ceil(box.max()[k] / edge)) + margin - grid.low[k];
        }
        return grid;
    }

    std::size_t voxelCount() const { return std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]); }
    std::size_t index(int x, int y, int z) const
    {
        return std::size_t(x) + std::size_t(size[0]) * (std::size_t(y) + std::size_t(size[1]) * std::size_t(z));
    }
    Vec3 centre(int x, int y, int z) const
    {
        return edge * Vec3(low[0] + x + 0.5, low[1] + y + 0.5, low[2] + z + 0.5);
    }

    friend bool operator==(const VoxelGrid&, const VoxelGrid&) = default;
};

/// 1 inside, 0 outside, one per voxel.
struct Voxels {
    VoxelGrid grid;
    std::vector<std::uint8_t> inside;
};

} // namespace bolster
