// Editing rules for curves in space: fixation curves and the targets of handle curves.
#pragma once

#include "Design.h"

#include <span>

namespace bolster::edits {

/// Moves control points of a curve by `delta` (mm).
Edit moveCurvePoints(const Design& design, ElementId id, std::span<const int> points, const Vec3& delta);
/// Inserts a control point at the parameter without changing the shape.
Edit insertCurvePoint(const Design& design, ElementId id, double parameter);
/// Removes a control point with the least change of shape.
Edit removeCurvePoint(const Design& design, ElementId id, int point);
/// Leads an open curve on from its end that is nearest to where the way (mm) begins, along the way. What is fixed
/// to all of it stays fixed to where it was. Empty for closed curves.
Edit leadCurveOn(const Design& design, ElementId id, std::span<const Vec3> way);

} // namespace bolster::edits
