// From the design's elements to soft targets.
#pragma once

#include "FrameFields.h"
#include "Ghosts.h"
#include "Problem.h"
#include "SolveInput.h"

#include <stop_token>

namespace bolster {

/// What is costly to make for ghosts and does not depend on the cover: kept while its element stays as it is.
struct GhostCache {
    FrameFields frames;
};

/// The sources that the input asks for. Elements whose files are not there are left out; `problems` gets what
/// prevents others. When stopped they are not all there.
Ghosts makeGhosts(const SolveInput& input, const SewnMesh& mesh, GhostCache& cache, Problems& problems,
                  WorkerPool& pool, const std::stop_token& stop = {});

} // namespace bolster
