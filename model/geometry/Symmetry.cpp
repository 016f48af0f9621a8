#include "Symmetry.h"

#include <cmath>
#include <numbers>

namespace bolster {

namespace {

template <class Vector>
bool usable(const Vector& point, const Vector& direction)
{
    return point.cwiseAbs().maxCoeff() <= largestCoordinate &&
           direction.cwiseAbs().maxCoeff() <= largestCoordinate && direction.norm() >= shortestDirection;
}

} // namespace

bool Symmetry::planeUsable() const
{
    return planePoint.allFinite() && planeNormal.allFinite() && usable(planePoint, planeNormal);
}

bool Symmetry::axisUsable() const
{
    return axisPoint.allFinite() && axisDirection.allFinite() && usable(axisPoint, axisDirection);
}

Vec3 Symmetry::mirrored(const Vec3& point) const
{
    const Vec3 origin = planeUsable() ? planePoint : Vec3(Vec3::Zero());
    return origin + mirroredDirection(point - origin);
}

Vec3 Symmetry::mirroredDirection(const Vec3& direction) const
{
    const Vec3 normal = planeUsable() ? planeNormal.normalized() : Vec3(Vec3::UnitX());
    return direction - 2 * normal.dot(direction) * normal;
}

Vec2 Symmetry::mirroredInLayout(const Vec2& point) const
{
    const Vec2 origin = axisUsable() ? axisPoint : Vec2(Vec2::Zero());
    const Vec2 along = axisUsable() ? axisDirection.normalized() : Vec2(Vec2::UnitY());
    const Vec2 way = point - origin;
    return origin + 2 * along.dot(way) * along - way;
}

double Symmetry::axisAngle() const
{
    return axisUsable() ? std::atan2(axisDirection.y(), axisDirection.x()) * 180 / std::numbers::pi : 90;
}

} // namespace bolster
