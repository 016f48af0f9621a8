#include "TriangleStrain.h"

#include <algorithm>
#include <cmath>

namespace bolster {

Eigen::Matrix<double, 3, 2> deformation(const std::array<Vec2, 3>& rest, const std::array<Vec3, 3>& place)
{
    Eigen::Matrix2d from;
    from << rest[1] - rest[0], rest[2] - rest[0];
    Eigen::Matrix<double, 3, 2> to;
    to << place[1] - place[0], place[2] - place[0];
    return to * from.inverse();
}

Eigen::Vector2d principalStretches(const std::array<Vec2, 3>& rest, const std::array<Vec3, 3>& place)
{
    const Eigen::Matrix<double, 3, 2> gradient = deformation(rest, place);
    const Eigen::Matrix2d square = gradient.transpose() * gradient;
    const double half = 0.5 * square.trace();
    const double root = std::sqrt(0.25 * std::pow(square(0, 0) - square(1, 1), 2) + square(0, 1) * square(0, 1));
    return {std::sqrt(half + root), std::sqrt(std::max(0.0, half - root))};
}

GrainStrain grainStrain(const std::array<Vec2, 3>& rest, const std::array<Vec3, 3>& place, double grain)
{
    const Eigen::Matrix<double, 3, 2> gradient = deformation(rest, place);
    const Vec3 warp = gradient * Vec2(std::cos(grain), std::sin(grain));
    const Vec3 weft = gradient * Vec2(std::sin(grain), -std::cos(grain));
    const double around = warp.cross(weft).norm();
    constexpr double flat = 1e-9; // a triangle without area has no angle
    return {warp.norm() - 1, weft.norm() - 1, warp.dot(weft) / std::max(around, flat)};
}

} // namespace bolster
