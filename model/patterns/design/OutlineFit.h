// Curves with few control points near the lines of a drawing.
#pragma once

#include "BSpline.h"
#include "Contour.h"

namespace bolster {

/// A polygon where the line has corners alone; else a cubic that passes within `tolerance` (mm) of its points, with
/// corners where the file has them, or where the line turns so much that no curve was meant. Nothing where it has
/// fewer than three points in different places (two of an open line).
std::optional<BSpline2> fittedCurve(const Contour& line, double tolerance = 0.02);

} // namespace bolster
