// Carries a surface over to a new triangulation through the pattern plane.
#pragma once

#include "SewnMesh.h"
#include "SheetState.h"

namespace bolster {

/// Positions and frames of `to` from those of `from`: each vertex takes those of its outline coordinates in the old
/// patch of the same id, or of the nearest point there. Patches that are new start rigidly. Sewn vertices get the
/// mean, fixed ones their targets.
SheetState transferState(const SewnMesh& from, const SheetState& state, const SewnMesh& to);

/// Gives the patches of `to` that `from` lacks but `older` has the place that they had there.
void fillMissing(const SewnMesh& older, const SheetState& olderState, const SewnMesh& from, const SewnMesh& to,
                 SheetState& state);

/// The largest distance (mm) between two surfaces of the same patches, point by point through the pattern plane.
double surfaceDistance(const SewnMesh& a, const SheetState& stateA, const SewnMesh& b, const SheetState& stateB);

} // namespace bolster
