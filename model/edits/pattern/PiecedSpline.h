// Closed curves made of polynomial pieces. Private to the library.
#pragma once

#include "BezierPieces.h"

#include <vector>

namespace bolster::edits {

/// Those of an open curve between its ends.
std::vector<double> innerKnots(const BSpline2& open);

/// In place of a closed curve, with its parameters and period, from these pieces of one degree, which cover the
/// period, and these knots of one turn, in any order. Where there are fewer knots than the pieces ask for, the
/// pieces must be parts of one polynomial there, or meet as smoothly as the knots let them.
BSpline2 closedSpline(const std::vector<BezierPiece<2>>& pieces, std::vector<double> knots,
                      const BSpline2& outline);

} // namespace bolster::edits
