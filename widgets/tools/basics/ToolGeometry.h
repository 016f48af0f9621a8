// What the drags of both views have in common.
#pragma once

#include "Camera.h"

#include <QColor>
#include <QPointF>

#include <vector>

namespace bolster {

inline constexpr double dragDistance = 4; ///< pixels: who has moved less has clicked

/// How far along a line (from `origin`, in lengths of the unit vector `along`) it is to the place nearest to the
/// ray through the pixel. 0 when the line points into the picture.
inline double alongLine(const Camera& camera, const Vec3& origin, const Vec3& along, QPointF pixel)
{
    const Camera::Ray ray = camera.ray({pixel.x(), pixel.y()});
    const Vec3 between = ray.origin - origin;
    const double share = along.dot(ray.direction), denominator = 1 - share * share;
    if (denominator < 1e-3)
        return 0;
    return (along.dot(between) - share * ray.direction.dot(between)) / denominator;
}

/// Of a pixel from a polyline in the picture, pixels. Parts behind the eye do not count.
double distanceInPicture(const Camera& camera, const std::vector<Vec3>& points, const Vec2& pixel);

/// x red, y green, z blue, as usual.
inline QColor axisColor(int axis)
{
    return axis == 0 ? QColor(0xd6, 0x45, 0x3d) : axis == 1 ? QColor(0x3c, 0x9a, 0x4f) : QColor(0x3b, 0x77, 0xd8);
}

} // namespace bolster
