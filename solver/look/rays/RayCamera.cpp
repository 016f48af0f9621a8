#include "PreviewRenderer.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

/// Columns: right, up, backward.
Eigen::Matrix3d axes(const RayCamera& view)
{
    const double sa = std::sin(view.azimuth), ca = std::cos(view.azimuth);
    const double se = std::sin(view.elevation), ce = std::cos(view.elevation);
    const Vec3 right(ca, sa, 0), backward(sa * ce, -ca * ce, se);
    Eigen::Matrix3d result;
    result << right, backward.cross(right), backward;
    return result;
}

} // namespace

Vec3 RayCamera::eye() const
{
    return target + distance * axes(*this).col(2);
}

RayCamera RayCamera::threeQuarter(const Box3& box, double aspect, double front)
{
    return around(box, aspect, RayCamera{}.azimuth + front, RayCamera{}.elevation);
}

RayCamera RayCamera::around(const Box3& box, double aspect, double azimuth, double elevation)
{
    RayCamera view;
    view.azimuth = azimuth;
    view.elevation = elevation;
    if (box.isEmpty())
        return view;
    const Eigen::Matrix3d basis = axes(view);
    const double tangentUp = std::tan(view.fieldOfView / 2) / 1.12; // a margin around the box
    const Vec2 tangent(tangentUp * std::max(aspect, 0.1), tangentUp);
    view.target = box.center();
    // Of each direction the two outermost corners, seen under the angle of the picture, say how far to go away
    // and where the middle is.
    for (int round = 0; round < 8; ++round) {
        Vec2 low = Vec2::Constant(1e300), high = Vec2::Constant(-1e300); // where the picture's borders cut depth 0
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 p = basis.transpose() * (box.corner(static_cast<Box3::CornerType>(corner)) - view.target);
            for (int axis = 0; axis < 2; ++axis) {
                high[axis] = std::max(high[axis], p[axis] + tangent[axis] * p.z());
                low[axis] = std::min(low[axis], p[axis] - tangent[axis] * p.z());
            }
        }
        view.distance = std::max(((high - low) / 2).cwiseQuotient(tangent).maxCoeff(), 1.0);
        view.target += basis.leftCols<2>() * ((low + high) / 2);
    }
    return view;
}

} // namespace bolster
