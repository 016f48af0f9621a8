// How a cover gets from one shape to the next before the eye.
#pragma once

#include "SurfaceMesh.h"

namespace bolster {

struct CoverMove {
    SurfaceMeshPtr from; ///< the triangles of the new surface, where the old one is
    double distance = 0; ///< mm: the farthest that one of its vertices has to go
};

/// Point by point through the pattern plane. Patches that are new do not move. `from` is null when nothing does.
CoverMove moveBetween(const SurfaceMesh& before, const SurfaceMesh& after);

} // namespace bolster
