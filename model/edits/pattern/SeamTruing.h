// Truing: outlines that go on without a kink where a seam ends.
#pragma once

#include "Design.h"

#include <span>

namespace bolster::edits {

/// How far the outlines beside a seam's end are from going on straight when both sides are laid together along the
/// seam: 180 degrees less the two angles between seam and neighbour, inside the patches. Degrees; positive: a
/// notch. Nothing where an end lies inside an edge, or is the tip of a dart. `first`: the end at which the first
/// side begins.
std::optional<double> kinkAtSeamEnd(const Design& design, const Seam& seam, bool first);

/// Kinks larger than that are corners that somebody wants, degrees.
inline constexpr double largestKink = 60;

/// Gives the edges beside both ends of the seams a common tangent: each of the two control points next to an end is
/// turned about it by half of the kink. The seams keep their shape and length. Polygons become cubics first.
Edit smoothAcrossSeamEnds(const Design& design, std::span<const ElementId> seams, Message* problem = nullptr);

} // namespace bolster::edits
