// The outline that takes the place of a dart when it is closed. Private to the library.
#pragma once

#include "BSpline.h"

#include <optional>

namespace bolster::edits {

/// The outline without its part from `from` to `to` (unwrapped), the legs of a dart with this tip; every parameter
/// elsewhere keeps its meaning, and the period stays. Where both sides tell what the mouth was before it was cut
/// out - one polynomial, or two that meet in a point or a corner - it is that again, without a control point more.
/// Else, and where the dart was turned open, it is a smooth piece, if need be with a little of the outline on both
/// sides so that no step is left; polygons become cubics for that. Where the outline bends too much, it is a
/// straight line with corners at its ends. Nothing when no such outline is possible.
std::optional<BSpline2> withoutLegs(const BSpline2& outline, double from, double to, const Vec2& tip);

/// Without the knots at a parameter where both sides are one polynomial: nobody sees that parts were joined there.
/// The same outline where they are not.
BSpline2 withoutJoint(const BSpline2& outline, double t);

} // namespace bolster::edits
