// Stretches of outlines, handle curves and fancy seams by their lengths.
#pragma once

#include "Design.h"

namespace bolster::edits {

/// Arc length (mm) between two control points of the element's curve in the pattern: between the places where they
/// have most influence, on a closed curve the shorter way. 0 when there are no such points.
double lengthBetween(const Design& design, ElementId id, int pointA, int pointB);

/// Gives that stretch another length (mm): its control points are scaled about its start, so that a straight edge
/// keeps its direction and a curve its shape. Empty when there is no such stretch, or no scale leads to the length.
Edit setLengthBetween(const Design& design, ElementId id, int pointA, int pointB, double length);

} // namespace bolster::edits
