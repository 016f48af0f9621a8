// Where a cover of many triangles begins: where it rests on fewer.
#pragma once

#include "MakeGhosts.h"
#include "PreparedSheet.h"
#include "SheetState.h"

#include <optional>

namespace bolster {

class Relaxation;

/// With many vertices a cover comes to rest on coarser triangles first, of which the coarsest do not depend on how
/// fine the last ones are: they decide which of its folds it takes. Nothing where there are few vertices, or when
/// stopped. To be called before the sheet's equations are factored: what it takes is free again by then.
std::optional<SheetState> coarseStart(const PreparedSheet& sheet, GhostCache& ghosts, WorkerPool& pool,
                                      const std::stop_token& stop = {});

/// Starts from there, or else from the canonical start: in either case from what depends on the design alone.
void startFromDesign(Relaxation& relaxation, std::optional<SheetState> coarse);

} // namespace bolster
