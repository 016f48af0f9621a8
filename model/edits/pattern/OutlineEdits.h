// New patches from outlines.
#pragma once

#include "Design.h"

namespace bolster::edits {

/// Adds a patch with this closed outline (layout coordinates, mm): the edit's last change. The outline
/// runs counter-clockwise in the result and begins at (0, 0) in its own coordinates: the lower left corner of its
/// box. Without `fabric`, or when that is none, it is made of the first fabric of the design; a design that has
/// none gets one in the same edit. Empty when `outlineProblem` has something to say.
Edit addPatch(const Design& design, BSpline2 outline, const std::string& name,
              std::optional<ElementId> fabric = {});

} // namespace bolster::edits
