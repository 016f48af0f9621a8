// Smooth curves through rows of points, such as those of a form's borders. Private to the library.
#pragma once

#include "CurveFit.h"

#include <vector>

namespace bolster {

// Points are Vec2 or Vec3, mm. A row has at least two.

/// By how much a way turns at a point, degrees; 0 where one of its sides has no length.
template <class Point>
double turnAt(const Point& before, const Point& at, const Point& after);

/// How far a curve through these places would lie from the edges between them, mm.
template <class Point>
double roundedBy(const Point& before, const Point& at, const Point& after);

/// How far along a row its points are, mm.
template <class Point>
std::vector<double> lengthsAlong(const std::vector<Point>& row);

/// A smooth row of points between corners, and more places on the curve through them: cubic Hermite pieces, whose
/// tangents are those of the parabolas through three neighbours. Where an edge is much longer than the other one
/// the row turns from a line into a bend: the line stays straight. `at` are the parameters of the points, from 0
/// on: lengths along this row, or along another one that has the same points elsewhere, mm.
template <class Point>
CurveSamples smoothSamples(const std::vector<Point>& row, const std::vector<double>& at);

/// An open cubic within `tolerance` (mm) of such a smooth curve, from the first point to the last one; a straight
/// line where the row is one. std::invalid_argument of rows without a length.
BSpline2 curveOf(const std::vector<Vec2>& row, double tolerance);

} // namespace bolster
