#include "FrameAngles.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double radiansPerDegree = M_PI / 180;

} // namespace

FrameAngles anglesOf(const Quat& rotation)
{
    const Eigen::Matrix3d r = rotation.normalized().toRotationMatrix();
    const double y = std::asin(std::clamp(-r(2, 0), -1.0, 1.0));
    FrameAngles angles{};
    if (std::abs(r(2, 0)) < 1 - 1e-9)
        angles = {std::atan2(r(2, 1), r(2, 2)), y, std::atan2(r(1, 0), r(0, 0))};
    else
        angles = {std::atan2(-r(1, 2), r(1, 1)), y, 0}; // x and z are the same axis then
    for (double& angle : angles)
        angle /= radiansPerDegree;
    return angles;
}

Quat rotationOf(const FrameAngles& angles)
{
    const auto about = [&](std::size_t i) {
        return Eigen::AngleAxisd(angles[i] * radiansPerDegree, Vec3::Unit(static_cast<Eigen::Index>(i)));
    };
    return Quat(about(2) * about(1) * about(0)).normalized();
}

} // namespace bolster
