// Knot vectors and the rules for them. Private to the library.
#pragma once

#include "Message.h"

#include <optional>
#include <vector>

namespace bolster::spline {

/// Uniform knots: 0 to n - d (open, clamped) or 0 to n (closed).
std::vector<double> defaultKnots(int degree, bool closed, int pointCount);

/// Those of a closed cubic with triple knots at the corners. The corners are valid.
std::vector<double> cornerKnots(int pointCount, const std::vector<int>& corners);

/// The smallest distance that two different knots may have. Closer ones count as the same place.
double smallestGap(const std::vector<double>& knots);

/// What is wrong with knots that are written out, for a valid degree and number of points.
std::optional<Message> knotProblem(int degree, bool closed, int pointCount, const std::vector<double>& knots);

} // namespace bolster::spline
