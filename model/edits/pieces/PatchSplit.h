// Cutting a patch in two along a line.
#pragma once

#include "EditOutcome.h"

#include <vector>

namespace bolster::edits {

/// Cuts a patch along a line through layout points (mm) that crosses its outline exactly twice; ends within 0.05 mm
/// of the outline lie on it, what is beyond the crossings does not matter. The larger piece keeps id and name. The
/// two are sewn together smoothly (C1), so that the surface stays as it is. Seams and fixations keep their places:
/// one that runs over the cut is divided, as are handle curves that cross it; a fancy seam across the cut is drawn
/// in both pieces. The twin of the patch is cut in the mirror image of the line. Refused with a reason.
Outcome splitPatch(const Design& design, ElementId patch, const std::vector<Vec2>& line);

} // namespace bolster::edits
