// Which stretches of outlines can be sewn together, and which way round. Parameters are those of the outlines.
#pragma once

#include "Design.h"

#include <span>

namespace bolster::edits {

/// Where an outline turns by more than 10 degrees, in [start, end), increasing: a point inserted into a straight
/// edge is no corner.
std::vector<double> outlineCorners(const BSpline2& outline);

/// From t0 on to t1, as seams store it: `from` in [start, end), `to` in (start, end].
Stretch stretchBetween(ElementId patch, const BSpline2& outline, double t0, double t1);

/// What no seam uses of the edge around a parameter, which goes from corner to corner and is the whole outline when
/// that has fewer than two. Nothing where the outline is sewn, or without such a patch.
std::optional<Stretch> freeStretchAt(const Design& design, ElementId patch, double parameter);
/// The seam that uses the outline at the parameter, and its stretch there.
std::optional<std::pair<ElementId, Stretch>> sewnAt(const Design& design, ElementId patch, double parameter);
/// 1 for the edge that begins at the outline's first corner; 0 without corners.
int edgeNumber(const BSpline2& outline, double parameter);

/// Why a stretch cannot be sewn, if so: it is empty, or seams other than `except` use a part of it.
std::optional<Message> stretchProblem(const Design& design, const Stretch& stretch, ElementId except = noElement);
/// Why a stretch cannot be sewn to several others, if so: one of them cannot be sewn at all, or two overlap.
std::optional<Message> sewingProblem(const Design& design, const Stretch& whole, std::span<const Stretch> row);

/// Whether the second stretch is usually walked backwards. Pieces are sewn right sides together, so it is whenever
/// both outlines run the same way round as seen from their right sides, as they mostly do; the layout has no say in
/// it, because it turns pieces but never mirrors them.
bool usuallyReversed(const Design& design, const Stretch& a, const Stretch& b);

/// The seams that sew one stretch to others in a row, each to a part of it in proportion to its length; with one
/// other just the seam between the two. Stretches of one outline follow each other as on it, those of several
/// outlines as they were given, or the other way round when they then lie nearer in the layout. `flipped` turns
/// the row and each seam round. Empty when a stretch does not lie on its outline.
std::vector<Seam> seamsInRow(const Design& design, const Stretch& whole, std::span<const Stretch> row,
                             bool flipped);

} // namespace bolster::edits
