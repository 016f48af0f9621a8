// Where selected control points are, in numbers.
#pragma once

#include "Design.h"
#include "Selection.h"

namespace bolster {

/// The selected points of outlines, handle curves and fancy seams that are there, in layout coordinates, mm.
std::vector<Vec2> placesInLayout(const Design& design, const Selection::Points& points);
/// Likewise the points of curves in space.
std::vector<Vec3> placesInSpace(const Design& design, const Selection::Points& points);

/// Gives all of them the same coordinate (axis 0 or 1) in the layout, mm; the others stay. Points in space are left
/// alone.
Edit placeInLayout(const Design& design, const Selection::Points& points, int axis, double value);
/// Likewise in space (axis 0 to 2); points of the pattern are left alone.
Edit placeInSpace(const Design& design, const Selection::Points& points, int axis, double value);

} // namespace bolster
