// Points measured on a surface, for scans.
#pragma once

#include "Geometry.h"

#include <cstdint>
#include <vector>

namespace bolster {

struct PointCloud {
    std::vector<Vec3> points;               ///< file units
    std::vector<std::uint32_t> colors = {}; ///< 0xRRGGBB of each point; empty where the file has none

    /// Of a file with more points than are kept: how many it has; each cube of a grid kept its first. 0: all are
    /// here.
    std::uint64_t thinnedFrom = 0;
    double spacing = 0; ///< the edge of those cubes, file units
};

} // namespace bolster
