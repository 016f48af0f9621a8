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

} // namespace bolster
