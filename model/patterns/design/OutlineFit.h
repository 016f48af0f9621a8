// Curves with few control points near the lines of a drawing.
#pragma once

#include "BSpline.h"
#include "Contour.h"

namespace bolster {

/// A polygon where the line has corners alone; else a cubic that passes within `tolerance` (mm) of its points, with
/// corners where the file has them, or where the line turns so much that no curve was meant. Nothing where it has
/// fewer than three points in different places (two of an open line).
std::optional<BSpline2> fittedCurve(const Contour& line, double tolerance = 0.02);

struct FittedLine {
    BSpline2 curve;
    double simplified = 0; ///< mm: how far it may be from the line, where that has more points than a curve can
};

/// The same with no more points than a curve can have (mostCurvePoints): lines that have more are simplified, by
/// half a millimetre at most. Nothing where that is not enough.
std::optional<FittedLine> fittedLine(const Contour& line);

/// Without points that are no farther than `tolerance` (mm) from a line through the others. Marked corners stay.
Contour thinned(const Contour& line, double tolerance);

} // namespace bolster
