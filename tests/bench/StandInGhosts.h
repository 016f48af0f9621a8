// Soft targets that cost what cushioning and scan fitting cost, for the seat. To be replaced by elements of the
// design as soon as it has them: what makeGhosts() makes goes first.
#pragma once

#include "Ghosts.h"

namespace bolster::bench {

/// A force field of 5 mm voxels around the seat's box, looked up at every vertex (paper, section 4.1).
Ghosts standInCushion(const SewnMesh& mesh);
/// So many points around the seat, of which the nearest to every vertex is found in every iteration (section 4.2).
Ghosts standInScan(const SewnMesh& mesh, int points);

} // namespace bolster::bench
