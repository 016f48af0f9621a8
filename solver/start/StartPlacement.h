// The canonical start: every patch laid rigidly where its fixations and seams want it (docs/solver.md, "Start").
#pragma once

#include "SewnMesh.h"
#include "SheetState.h"

namespace bolster {

/// Patches with fixations by their best rigid fit, the others through seams to placed ones, most seam points first;
/// then every sewn vertex to the mean of its places and every fixed one to its target.
SheetState startPlacement(const SewnMesh& mesh);

} // namespace bolster
