// An outline that is being drawn: corners and smooth points, and the curve through them.
#pragma once

#include "BSpline.h"

#include <QPainterPath>

#include <vector>

namespace bolster {

/// The curve passes through the point. At a smooth one it has the tangent `handle` (mm, towards the next point) on
/// both sides.
struct DraftPoint {
    Vec2 at = Vec2::Zero();
    std::optional<Vec2> handle{}; ///< nothing: a corner
};

/// The closed curve, counter-clockwise or not as it was drawn: a polygon when all points are corners, else a cubic
/// with a triple knot at each corner and a double one at each smooth point. Edges between two corners are exactly
/// straight. Points that lie on each other count once. Nothing when it is no curve.
std::optional<BSpline2> draftOutline(std::vector<DraftPoint> points);

/// The same pieces from the first point to the last, not closed.
QPainterPath draftPath(const std::vector<DraftPoint>& points);
/// The piece from the last point to the first.
QPainterPath closingPath(const std::vector<DraftPoint>& points);
/// An open path that meets itself; `tolerance` in the path's unit is the flatness that is good enough.
bool crossesItself(const QPainterPath& path, double scale);

/// A rectangle: four corners, from two opposite ones.
std::optional<BSpline2> rectangleOutline(const Vec2& a, const Vec2& b);
/// A closed cubic without corners within 0.03 % of the ellipse in the rectangle.
std::optional<BSpline2> ellipseOutline(const Vec2& a, const Vec2& b);

} // namespace bolster
