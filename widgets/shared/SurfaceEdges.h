// The lines of a cover's mesh: its edges, and the outlines of its patches. All of it takes one walk over the mesh.
#pragma once

#include "SurfaceMesh.h"

namespace bolster {

using SurfaceEdge = std::array<std::uint32_t, 2>;
using SurfaceRun = std::vector<std::uint32_t>; ///< vertices, each joined to the next one

/// Every edge of a patch once.
std::vector<SurfaceEdge> edgesOf(const SurfaceTopology& topology, const SurfaceTopology::PatchRange& patch);

/// The outline of a patch; ends where it begins.
SurfaceRun outlineOf(const SurfaceTopology::PatchRange& patch);

/// The stretches of all outlines that belong to no seam.
std::vector<SurfaceRun> unsewnOutlines(const SurfaceTopology& topology);

} // namespace bolster
