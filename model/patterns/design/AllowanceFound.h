// The seam allowance between a sewing line and a cut line. Private to the library.
#pragma once

#include "BSpline.h"
#include "Contour.h"
#include "CutAllowance.h"

#include <vector>

namespace bolster {

/// Of a stretch of the outline between two corners.
struct EdgeWidth {
    double from = 0; ///< parameters
    double to = 0;
    double width = 0; ///< mm
    bool sure = true; ///< it was measured in several places
};

struct FoundAllowance {
    CutAllowance usual;           ///< what most of the outline has
    std::vector<EdgeWidth> edges; ///< those that have another one
    double tooWide = 0; ///< mm: the widest that is wider than an allowance may be, and has the usual one; 0: none
    double off =
        0; ///< mm: how far the cut line that follows from these is from the given one where it differs most
};

/// How far beyond the outline fabric was cut, edge by edge. Where one of the others lies between them nothing is
/// known.
FoundAllowance foundAllowance(const BSpline2& outline, const Contour& cut, const std::vector<Contour>& others = {});

} // namespace bolster
