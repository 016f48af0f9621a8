// Positions and frames of a cover.
#pragma once

#include "Geometry.h"

namespace bolster {

/// Columns of four numbers: x y z 0, or w x y z.
using Columns = Eigen::Matrix4Xd;

/// Column-wise: positions of the unknowns in mm (free ones first, then fixed ones), unit quaternions (w, x, y, z)
/// of the vertices' frames. A frame turns the pattern plane into the tangent plane.
struct SheetState {
    Eigen::Matrix3Xd positions;
    Eigen::Matrix4Xd frames;
};

/// The rotation matrix of a unit quaternion (w, x, y, z).
inline Eigen::Matrix3d rotationOf(const Eigen::Vector4d& q)
{
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    Eigen::Matrix3d r;
    r << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), //
        2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),  //
        2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y);
    return r;
}

} // namespace bolster
