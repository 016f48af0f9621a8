// Where the content of a file stands in the design.
#pragma once

#include "Geometry.h"

namespace bolster {

/// A file point p becomes R(rotation) * (scale * p) + position.
struct Placement {
    double scale = 1; ///< mm per file unit, > 0
    Vec3 position = Vec3::Zero();
    Quat rotation = Quat::Identity();

    Vec3 placed(const Vec3& filePoint) const { return rotation * (scale * filePoint) + position; }

    /// The inverse.
    Vec3 filePoint(const Vec3& placed) const { return fileDirection(placed - position); }
    Vec3 fileDirection(const Vec3& direction) const { return rotation.conjugate() * direction / scale; }

    friend bool operator==(const Placement& a, const Placement& b)
    {
        return a.scale == b.scale && a.position == b.position && a.rotation.coeffs() == b.rotation.coeffs();
    }
};

} // namespace bolster
