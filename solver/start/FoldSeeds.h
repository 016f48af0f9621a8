// Where compressed cloth folds to begin with (docs/solver.md, "Start").
#pragma once

#include "SewnMesh.h"
#include "SheetState.h"

namespace bolster {

/// Of a cover that was relaxed from its start placement. Cloth that is compressed is pushed off the plane that it
/// lies in by a smooth deterministic ripple of about 0.002 D, or it would stay on the saddle between its folds;
/// what is too large for its rim in both directions stands up on it. Cloth that is stretched or at rest is left
/// alone.
void seedFolds(const SewnMesh& mesh, SheetState& state);

} // namespace bolster
