// What fancy seams press into the cover or raise from it (paper, section 3.5).
#pragma once

#include "OutlineSampling.h"
#include "SewnMesh.h"
#include "SheetState.h"

namespace bolster {

/// The cover is solved as if there were no fancy seams; what is published is pushed along the outside normal of
/// that surface. So the outer lines lie exactly on it and follow it, and depth and profile ask for no solve.
///
/// Where the seam ends inside the patch, or at a border that is sewn or fixed, it fades out within one width.
std::vector<SewnMesh::Relief> makeReliefs(const SewnMesh& mesh, const OutlineSampling& sampling,
                                          const Design& design);

/// Depth and profile again, when only these have changed.
void updateReliefs(SewnMesh& mesh, const Design& design);

/// Unit normals per vertex to the outside, smooth within a patch, from positions per vertex.
std::vector<Eigen::Vector3f> smoothNormals(const SurfaceTopology& topology, const std::vector<Vec3>& positions);

/// The cover as it is seen: positions per vertex with the fancy seams, mm.
std::vector<Vec3> coverPositions(const SewnMesh& mesh, const SheetState& state);

} // namespace bolster
