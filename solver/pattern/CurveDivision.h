// How many edges a piece of a pattern curve needs.
#pragma once

#include "ArcLength.h"

namespace bolster {

/// A piece of a curve between two arc lengths (mm) gets edges of about `edgeLength` (mm); shorter ones where it
/// bends sharply. At least one.
int edgesOf(const BSpline2& curve, const ArcLength2& length, double s0, double s1, double edgeLength);

} // namespace bolster
