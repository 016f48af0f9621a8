// The outline that takes the place of a dart when it is closed. Private to the library.
#pragma once

#include "BSpline.h"

#include <optional>

namespace bolster::edits {

/// The outline without its part from `from` to `to` (unwrapped), the legs of a dart; every parameter elsewhere
/// keeps its meaning, and the period stays. Where both sides tell what the mouth was before it was cut out - one
/// polynomial, or two that meet in a point or a corner - it is that again, without a control point more. Else it is
/// a smooth piece, or, where the outline bends too much for that, a straight line with corners at its ends. Nothing
/// when no such outline is possible.
std::optional<BSpline2> withoutLegs(const BSpline2& outline, double from, double to);

/// Without the knots at a parameter where both sides are one polynomial: nobody sees that parts were joined there.
/// The same outline where they are not.
BSpline2 withoutJoint(const BSpline2& outline, double t);

} // namespace bolster::edits
