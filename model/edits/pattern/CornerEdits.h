// Corners and straight stretches of outlines, handle curves and fancy seams. Parameters of seams stay valid: no
// stretch has to be changed.
#pragma once

#include "Design.h"

#include <span>

namespace bolster::edits {

/// The curve gets a corner at each of these control points; the points stay where they are.
Edit makeCorners(const Design& design, ElementId id, std::span<const int> points);
/// The curve runs smoothly past these control points, which stay where they are. A polygon becomes a cubic whose
/// other edges stay exactly straight.
Edit makeSmooth(const Design& design, ElementId id, std::span<const int> points);
/// Makes the stretch between two control points straight: of a closed curve the shorter one. The two become
/// corners, the points between them move onto the line.
Edit straighten(const Design& design, ElementId id, int pointA, int pointB);

/// Whether a control point of the element's curve in the pattern is a corner; the ends of an open one are.
bool isCornerPoint(const Design& design, ElementId id, int point);

} // namespace bolster::edits
