// Brings a prepared sheet to another design on the same triangles.
#pragma once

#include "PatternWarp.h"
#include "PreparedSheet.h"
#include "SolvePlan.h"

namespace bolster {

/// What `input` has otherwise than the sheet's design; `plan` (less than Rebuild) says how much that is. Outlines
/// take the triangles with them, by `warp`, which is made when it is first needed. Ghosts and the relaxation are
/// the caller's. False when triangles must be made anew: elements came or went, the triangles would be too
/// distorted. `problems` gets what is wrong with the design.
bool followDesign(PreparedSheet& sheet, std::optional<PatternWarp>& warp, const SolveInput& input, SolvePlan plan,
                  WorkerPool& pool, Problems& problems);

/// Whether two designs have the same elements, whatever is in them.
bool sameElements(const Design& a, const Design& b);

} // namespace bolster
