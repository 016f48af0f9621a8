// Where rows of stitches and piping run in the pattern.
#pragma once

#include "Design.h"

#include <vector>

namespace bolster {

/// A line in a patch, a point about every millimetre; outline coordinates, mm.
struct TrimRow {
    ElementId patch{};
    std::vector<Vec2> points;
    bool closed = false; ///< the last point is followed by the first
};

/// The rows of stitches of a seam, fixation seam, outline trim or fancy seam. Where a row inside an outline would
/// come nearer to it than asked, as in a narrow corner, it is cut short.
std::vector<TrimRow> stitchRows(const Design& design, const Element& element);
/// The lines that piping follows: of a seam those of both of its sides, with as many points each.
std::vector<TrimRow> pipingRows(const Design& design, const Element& element);

} // namespace bolster
