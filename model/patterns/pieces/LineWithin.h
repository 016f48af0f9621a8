// How lines of a drawing lie in each other. Private to the library.
#pragma once

#include "Contour.h"

namespace bolster {

/// mm: a turn point and its vertex, a line and one that lies on it.
inline constexpr double sameVertex = 0.05;

/// Whether all of the inner line lies inside the outer one, or on it.
bool isWithin(const Contour& inner, const Contour& outer);
/// Whether the inner line follows the outer one at a distance, as a sewing line does.
bool followsWithin(const Contour& inner, const Contour& outer);
/// Closed ones first, the larger ones before the smaller ones.
void sortLargestFirst(std::vector<Contour>& lines);

} // namespace bolster
