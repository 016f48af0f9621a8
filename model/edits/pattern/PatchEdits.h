// Editing rules for patches, their outlines and the curves drawn in them. Pure: Design in, Edit out; an empty edit
// when nothing would change.
#pragma once

#include "Design.h"

#include <span>

namespace bolster::edits {

/// Moves control points of an outline, handle curve or fancy seam by `delta` (outline coordinates, mm).
Edit movePatchPoints(const Design& design, ElementId id, std::span<const int> points, const Vec2& delta);
/// Inserts a control point at the parameter without changing the shape (knot insertion).
Edit insertPatchPoint(const Design& design, ElementId id, double parameter);
/// Removes a control point with the least change of shape.
Edit removePatchPoint(const Design& design, ElementId id, int point);
/// Moves patches in the layout (mm). The surface does not change.
Edit movePatches(const Design& design, std::span<const ElementId> patches, const Vec2& delta);
/// Turns patches in the layout about a layout point, counter-clockwise (degrees).
Edit turnPatches(const Design& design, std::span<const ElementId> patches, const Vec2& centre, double degrees);

} // namespace bolster::edits
