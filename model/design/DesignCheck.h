// What is wrong with the elements of a design, and what remains usable.
#pragma once

#include "Design.h"

namespace bolster {

/// Every rule that needs only the design: ranges, references, stretches, outlines that cross themselves, seams of
/// a stretch with itself ... Warnings too (ease over 5 %). Ordered by element, then field.
Problems checkDesign(const Design& design);

/// The design without the elements that have errors, and without those that refer to them.
/// `leftOut` gets one problem for each element that was left out.
Design usablePart(const Design& design, const Problems& problems, Problems* leftOut = nullptr);

/// Length of the longer stretch over that of the shorter one, minus 1. 0 when an end is missing.
double seamEase(const Design& design, const Seam& seam);

/// Where a closed 2D curve crosses or touches itself, if it does (a point of the curve).
std::optional<Vec2> selfIntersection(const BSpline2& outline);

} // namespace bolster
