// B-splines as painter paths: exact, a cubic piece for each polynomial piece.
#pragma once

#include "BSpline.h"

#include <QPainterPath>

#include <functional>

namespace bolster {

/// From `from` to `to` (unwrapped: `to` > `from`, beyond the domain's end on closed curves), each point placed by
/// `place`, which must be affine.
QPainterPath curvePath(const BSpline2& curve, double from, double to,
                       const std::function<Vec2(const Vec2&)>& place);
/// The whole curve; closed curves give a closed path.
QPainterPath curvePath(const BSpline2& curve, const std::function<Vec2(const Vec2&)>& place);

inline QPointF toPoint(const Vec2& v)
{
    return {v.x(), v.y()};
}
inline Vec2 toVec(QPointF p)
{
    return {p.x(), p.y()};
}

} // namespace bolster
