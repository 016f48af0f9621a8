// What the design is mirrored at: a plane in space, and an axis in the layout of the pattern.
#pragma once

#include "Geometry.h"

namespace bolster {

/// Neither the surface nor anything else depends on it, only where twins are.
struct Symmetry {
    Vec3 planePoint = Vec3::Zero();     ///< mm
    Vec3 planeNormal = Vec3::UnitX();   ///< of any length
    Vec2 axisPoint = Vec2::Zero();      ///< in the layout, mm
    Vec2 axisDirection = Vec2::UnitY(); ///< of any length

    /// Whether all numbers are finite and within 1e7, and the direction has a length; else the default is used.
    bool planeUsable() const;
    bool axisUsable() const;

    Vec3 mirrored(const Vec3& point) const;
    Vec3 mirroredDirection(const Vec3& direction) const;
    Vec2 mirroredInLayout(const Vec2& point) const;
    /// Direction of the axis, degrees, counter-clockwise from x.
    double axisAngle() const;

    friend bool operator==(const Symmetry&, const Symmetry&) = default;
};

/// Outline coordinates have a mirror of their own: x = 0, whatever the layout. It is exact.
inline Vec2 mirroredInOutline(const Vec2& point)
{
    return {0.0 - point.x(), point.y()}; // no -0
}

} // namespace bolster
