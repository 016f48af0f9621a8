// Vector types that the whole program shares. Lengths are millimetres.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace bolster {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Quat = Eigen::Quaterniond;
using Box2 = Eigen::AlignedBox2d;
using Box3 = Eigen::AlignedBox3d;

/// Twice the area of the triangle 0, a, b: positive when b lies to the left of a.
inline double cross(const Vec2& a, const Vec2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

inline constexpr double largestCoordinate = 1e7;  ///< mm: no place of a design is farther from the origin
inline constexpr double shortestDirection = 1e-6; ///< of a vector that is only a direction

} // namespace bolster
