// How much a cover bends, vertex by vertex.
#pragma once

#include "SurfaceMesh.h"

#include <vector>

namespace bolster {

/// Mean of the two principal curvatures at each vertex, 1/m; positive where the cover bulges to its right side,
/// across seams too. NaN at vertices without triangles of any area.
///
/// The integral of the mean curvature over an edge is half its length times the angle between its triangles; each
/// end gets half of it (D. Cohen-Steiner and J.-M. Morvan, "Restricted Delaunay triangulations and normal cycle",
/// 2003).
std::vector<float> meanCurvature(const SurfaceMesh& surface);

} // namespace bolster
