// Places on an outline as one measures them: so far along it from a corner; and what corners turn by.
#pragma once

#include "BSpline.h"

#include <optional>

namespace bolster {

/// From a corner along a closed curve.
struct CornerWay {
    double corner = 0;    ///< its parameter
    double length = 0;    ///< mm, not negative
    bool forwards = true; ///< in the direction in which the curve runs
};

/// From the nearer of the two corners beside a place of a closed curve; nothing where it has no corners.
std::optional<CornerWay> wayFromCorner(const BSpline2& outline, double t);
/// The parameter, in the domain, at the end of the way; nothing when it leads past the next corner.
std::optional<double> endOfWay(const BSpline2& outline, const CornerWay& way);
/// What a closed curve turns by at a place, radians, positive to the left; 0 where it is smooth.
double turnAt(const BSpline2& outline, double t);

} // namespace bolster
