// Points measured on a surface, for scans.
#pragma once

#include "Geometry.h"

#include <vector>

namespace bolster {

struct PointCloud {
    std::vector<Vec3> points; ///< file units
};

} // namespace bolster
