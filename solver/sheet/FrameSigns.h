// Signs of the quaternions that stand for frames.
#pragma once

#include "SewnMesh.h"
#include "WorkerPool.h"

#include <Eigen/Core>

#include <vector>

namespace bolster {

/// q and -q are the same rotation, but L2 averages them to nothing: a frame of the wrong sign among its neighbours
/// is a knot that never comes undone. Flips frames (one column per vertex) so that neighbours in a patch lie in one
/// hemisphere. A patch has no holes, so its signs can always be chosen like that where frames change little from
/// vertex to vertex. Cheap when they agree already. Returns the vertices of those that it has flipped.
std::vector<int> alignSigns(const SewnMesh& mesh, WorkerPool& pool, Eigen::Matrix4Xd& frames);

} // namespace bolster
