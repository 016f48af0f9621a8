// Where a cover of many triangles begins: where it rests on fewer.
#pragma once

#include "MakeGhosts.h"
#include "PreparedSheet.h"
#include "Relaxation.h"

namespace bolster {

/// Starts the relaxation of a prepared sheet from what depends on the design alone. With many vertices it comes to
/// rest on coarser triangles first, of which the coarsest do not depend on how fine the last ones are: they decide
/// which of its folds the cover takes. When stopped the start means nothing.
void startFromDesign(const PreparedSheet& sheet, Relaxation& relaxation, GhostCache& ghosts, WorkerPool& pool,
                     const std::stop_token& stop = {});

} // namespace bolster
