// Which stretch of an outline is meant by what is selected or clicked.
#pragma once

#include "Design.h"

#include <optional>

namespace bolster {

class Selection;

/// The edge of an outline between two corners that contains the parameter; the whole outline when it has none.
Stretch outlineEdgeAt(ElementId patch, const BSpline2& outline, double parameter);
/// Whether it is such an edge of its patch.
bool isOutlineEdge(const Design& design, const Stretch& stretch);
/// Whether the stretch, which must be one of this outline, contains the parameter.
bool stretchContains(const Stretch& stretch, const BSpline2& outline, double parameter);
/// Through all selected points of an outline, without the longest way between two of them; nothing with fewer than
/// two.
std::optional<Stretch> stretchThroughPoints(const Design& design, const Selection& selection, ElementId patch);
/// The only selected edge, the stretch through selected points of the only outline that has two, or of the only
/// selected seam (its first side) or fixation.
std::optional<Stretch> stretchToFix(const Design& design, const Selection& selection);

} // namespace bolster
