// What pictures need to know about the shape of meshes.
#pragma once

#include "Geometry.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace bolster {

/// A unit normal for each corner of each triangle: smooth across edges that bend by less than `crease` (radians),
/// sharp across others. Degenerate triangles get +z.
std::vector<std::array<Eigen::Vector3f, 3>> cornerNormals(std::span<const Vec3> points,
                                                          std::span<const std::array<std::uint32_t, 3>> triangles,
                                                          double crease = 0.7);

/// Where somebody who wants to sit down comes from: the side opposite to the highest parts (the back), snapped to
/// an axis; radians about z, 0 is from -y, positive towards +x. 0 when no side stands out. z is up.
double frontAzimuth(std::span<const Vec3> points);

} // namespace bolster
