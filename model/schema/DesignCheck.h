// What is wrong with the elements of a design, and what remains usable.
#pragma once

#include "DesignJson.h"

namespace bolster {

/// Every rule that needs only the design: ranges, references, stretches, outlines that cross themselves, seams of
/// a stretch with itself ... Warnings too (ease over 5 %). Elements that could not be read repeat their problems.
/// Ordered by element, then field.
Problems checkDesign(const Design& design);

/// The problems of reading and those of checkDesign, each once.
Problems allProblems(const ReadDesign& read);

/// The design without the elements that have errors, and without those that refer to them. A bad edge length
/// becomes 12 mm. `leftOut` gets one warning for each element that was left out, and one for the edge length.
Design usablePart(const Design& design, const Problems& problems, Problems* leftOut = nullptr);

/// The edge length (mm) below which the patches would need more than five million triangles.
double smallestEdgeLength(const Design& design);

/// Seams with more ease than this get a warning: the fabric puckers.
inline constexpr double mostEase = 0.05;

/// Length of the longer stretch over that of the shorter one, minus 1. 0 when an end is missing.
double seamEase(const Design& design, const Seam& seam);

/// Whether two sides of a seam (mm) differ by more than cloth takes up without folds, beyond what is wanted.
bool puckers(double lengthA, double lengthB, double wanted);
bool puckers(const Design& design, const Seam& seam);

/// What is wrong with the shape of an outline, if anything: it must be closed, enclose an area and not meet itself.
/// Fast enough for every step of a drag.
std::optional<Message> outlineProblem(const BSpline2& outline);

/// Where a closed 2D curve crosses or touches itself, if it does (a point of the curve).
std::optional<Vec2> selfIntersection(const BSpline2& outline);

} // namespace bolster
