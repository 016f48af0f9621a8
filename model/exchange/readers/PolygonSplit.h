// Polygons of imported meshes as triangles.
#pragma once

#include "Geometry.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace bolster {

/// Appends triangles of indices into `corners` (3 or more): a fan when the polygon is convex, ears when it is not.
/// Always corners.size() - 2 triangles; a fan too for polygons that cross themselves or have no area. Looking for
/// ears may take the cube of the number of corners: `effort` counts down, and when it is used up there are fans, so
/// that no file can keep us busy for ever.
void splitPolygon(std::span<const Vec3> corners, std::vector<std::array<std::uint32_t, 3>>& triangles,
                  std::int64_t& effort);

} // namespace bolster
