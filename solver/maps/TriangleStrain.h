// How much a triangle of the cover is strained.
#pragma once

#include "Geometry.h"

#include <array>

namespace bolster {

/// A triangle's map from the pattern (mm) to its place (mm), which turns directions of the pattern into those of
/// the cover.
Eigen::Matrix<double, 3, 2> deformation(const std::array<Vec2, 3>& rest, const std::array<Vec3, 3>& place);

/// Principal stretches (larger first) of a triangle's map from `rest` (mm) to `place` (mm).
Eigen::Vector2d principalStretches(const std::array<Vec2, 3>& rest, const std::array<Vec3, 3>& place);

struct GrainStrain {
    double along = 0;  ///< stretch minus 1
    double across = 0; ///< the grain
    double shear = 0;  ///< tangent of the angle by which they leave the right angle; positive when it gets smaller
};
/// `grain` is the direction of the warp in outline coordinates, radians.
GrainStrain grainStrain(const std::array<Vec2, 3>& rest, const std::array<Vec3, 3>& place, double grain);

} // namespace bolster
