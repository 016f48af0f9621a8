// How much of a cover each vertex stands for.
#pragma once

#include "SurfaceMesh.h"

namespace bolster {

/// A third of the triangles around each vertex, mm^2. `positions` of all of the topology's vertices, mm.
std::vector<double> vertexAreas(const SurfaceTopology& topology, const std::vector<Vec3>& positions);

} // namespace bolster
