// Seams that fold a patch upon itself: those of darts.
#pragma once

#include "Design.h"

#include <optional>

namespace bolster {

/// The sides of such a seam in the order in which the outline runs, with the seam's own parameters.
struct FoldedSides {
    ElementId patch{};
    Stretch first;           ///< ends at the tip
    Stretch second;          ///< begins there
    Vec2 tip = Vec2::Zero(); ///< outline coordinates, mm
};

/// Nothing for a seam whose sides do not meet in one point of one outline.
std::optional<FoldedSides> foldedSides(const Design& design, const Seam& seam);

} // namespace bolster
