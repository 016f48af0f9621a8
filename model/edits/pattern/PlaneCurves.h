// Shapes of curves in the pattern, for the editing rules. Private to the library.
#pragma once

#include "BSpline.h"

#include <optional>
#include <vector>

namespace bolster::edits {

using Map2 = Eigen::Affine2d;

/// Nothing when a point would leave the sensible range.
std::optional<BSpline2> mapped(const BSpline2& curve, const Map2& map);

/// The same curve as a cubic, equal at every parameter: every break becomes a corner, straight edges get points at
/// their thirds. Cubics stay as they are.
BSpline2 raisedToCubic(const BSpline2& curve);

/// A straight line through points as an open curve of the degree; its knots are `start` and on, `speed` mm each.
BSpline2 polyline(const std::vector<Vec2>& points, int degree, double start, double speed);

/// Open curves of one degree, each beginning where the one before ends, as one closed curve with corners at the
/// joints. Its domain begins at 0; `starts` becomes the parameter at which each curve begins.
BSpline2 joined(const std::vector<BSpline2>& curves, std::vector<double>* starts);

/// An open curve that ends where it begins as a closed one, with a corner there.
BSpline2 closedCurve(const BSpline2& curve);
BSpline3 closedCurve(const BSpline3& curve);

/// The same closed curve with its domain beginning elsewhere; what joined() gives begins at 0.
BSpline2 beginningAt(const BSpline2& curve, double start);
/// The same place of a closed curve, by a parameter of its domain.
double inFirstTurn(const BSpline2& curve, double t);

/// Whether control point i is where the curve has a corner.
bool isCorner(const BSpline2& curve, int i);

} // namespace bolster::edits
