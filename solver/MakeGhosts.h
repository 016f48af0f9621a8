// From the design's elements to soft targets.
#pragma once

#include "Ghosts.h"
#include "Problem.h"
#include "SolveInput.h"

#include <stop_token>

namespace bolster {

/// What is costly to make for ghosts and does not depend on the cover: kept while its element stays as it is.
struct GhostCache {};

/// The sources that the input asks for. Elements whose files are not there are left out; `problems` gets what
/// prevents others.
Ghosts makeGhosts(const SolveInput& input, const SewnMesh& mesh, GhostCache& cache, Problems& problems,
                  const std::stop_token& stop = {});

} // namespace bolster
