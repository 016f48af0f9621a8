// A frame's rotation as three numbers that people can type.
#pragma once

#include "Geometry.h"

#include <array>

namespace bolster {

/// Turns about the fixed axes x, y, z, one after the other, in degrees, counter-clockwise seen from the axis' tip.
using FrameAngles = std::array<double, 3>;

/// Of two ways to say the same one is chosen; looking along y straight up or down, z is 0.
FrameAngles anglesOf(const Quat& rotation);
Quat rotationOf(const FrameAngles& angles);

} // namespace bolster
