#include "MakeGhosts.h"

#include "CushionGhosts.h"

namespace bolster {

Ghosts makeGhosts(const SolveInput& input, const SewnMesh& mesh, GhostCache& cache, Problems& problems,
                  WorkerPool& pool, const std::stop_token& stop)
{
    Ghosts ghosts;
    addCushionGhosts(input, mesh, cache.frames, pool, stop, ghosts, problems);
    addContactGhosts(input, mesh, cache.frames, pool, stop, ghosts);
    if (!stop.stop_requested())
        cache.frames.endRound();
    return ghosts;
}

} // namespace bolster
