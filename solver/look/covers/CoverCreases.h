// Where a cover stays sharp when it is refined: along C0 seams and folded lines, and at corners.
#pragma once

#include "LoopStencils.h"
#include "SurfaceMesh.h"

namespace bolster {

/// The cover twice: with sewn vertices merged, which gives positions, and patch by patch, which gives pattern
/// coordinates. A vertex is a corner in both or in neither, except along smooth seams.
struct CoverCreases {
    LoopMesh merged;                    ///< of unknowns
    LoopMesh patches;                   ///< of vertices
    std::vector<std::uint32_t> unknown; ///< of each vertex

    /// Where the topology does not say which vertices are sewn, none are.
    static CoverCreases of(const SurfaceTopology& topology);
};

} // namespace bolster
