// Two patches become one along the seam between them.
#pragma once

#include "EditOutcome.h"

namespace bolster::edits {

/// Moves and turns the seam's second patch so that its stretch lies on that of the first one, and makes one patch
/// of the two, with id, name, fabric and place of the first one. Seams of the two that continue this one on both
/// sides belong to it; others remain as seams of the new patch with itself. Where the stretches' ends do not meet
/// exactly, the outline goes through the middle. Other seams, fixations and curves keep their places; what lies on
/// the stretches that vanish is dropped. What a cut had divided becomes one again (joinDivided). Twins of both that
/// are sewn alike are merged, too; else the links end. Refused with a reason when the seam joins a patch to itself,
/// right side to wrong side, stretches that differ by more than 5 % in length, or when the new outline would cross
/// itself.
Outcome mergePatches(const Design& design, ElementId seam);

} // namespace bolster::edits
