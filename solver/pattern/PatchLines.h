// Handle curves and fancy seams as polylines in their patches (paper, section 3.5).
#pragma once

#include "Design.h"
#include "Problem.h"

#include <array>
#include <optional>
#include <vector>

namespace bolster {

/// A handle curve, or one of the parallel lines of a fancy seam.
struct PatchLine {
    ElementId element{};
    ElementId patch{};
    std::vector<Vec2> points;   ///< outline coordinates, mm; of a closed line the first one is not repeated
    std::vector<double> places; ///< arc length along the drawn curve at which each point belongs, mm
    bool closed = false;
    std::vector<double> fractions; ///< of a handle curve: where on its target each point belongs, 0 to 1
    double across = 0;             ///< of a fancy seam: -1 and 1 are the outer lines, 0 the middle
    /// Where start and end lie on the outline (parameters), if they do.
    std::array<std::optional<double>, 2> onOutline;
    double reach = 0; ///< mm: a cut of the outline so near to such an end is that end
};

struct PatchLines {
    std::vector<PatchLine> lines; ///< by element; the lines of a fancy seam by `across`
    Problems problems;            ///< elements that have no lines, and why
};

/// Curves are sampled as outlines are, corners kept. A fancy seam becomes its two outer lines, the middle one and
/// as many between them as profile and edge length ask for. Whatever comes so close to the outline, to itself or to
/// another one that triangles between them would be spoiled is refused. The design must be free of errors.
PatchLines drawPatchLines(const Design& design);

} // namespace bolster
