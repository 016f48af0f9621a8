// What closes the openings of a cover.
#pragma once

#include "SurfaceMesh.h"

#include <array>
#include <vector>

namespace bolster {

/// Triangles from each border of the sewn cover to its middle, so that cover and lids together are closed and face
/// outwards; mm. Lids of flat borders are flat.
std::vector<std::array<Vec3, 3>> coverLids(const SurfaceMesh& cover);

} // namespace bolster
