// An outline whose material is shifted along it: what a slipped notch does.
#pragma once

#include "BSpline.h"

namespace bolster {

/// The same shape, but between the parameters `from` and `to` each place has moved along the outline: by `by` mm
/// (at most a third of the length there) towards greater parameters half way, by nothing at both ends. As near to
/// that as the control points in between come; without any it is the outline itself.
///
/// On triangles whose samples keep their parameters the vertices of a sewn edge so get other material. A solve
/// on new triangles samples by arc length and sees nothing of it.
BSpline2 slippedOutline(const BSpline2& outline, double from, double to, double by);

} // namespace bolster
