// Frames with fewer triangles: a cover touches a frame, and does not look at its screws.
#pragma once

#include "TriangleMesh.h"

#include <stop_token>

namespace bolster {

struct SimplifiedMesh {
    TriangleMesh mesh;
    double off = 0; ///< file units: about how far it is from what it was, at most
};

/// The wanted parts (all, when `wanted` is empty), with about so many triangles in all, each part in proportion.
/// Its points are points of the mesh; where parts meet, and at borders of meshes with parts, they all stay, so
/// there may be more triangles. Takes about a second for a million of them. Nothing when stopped.
SimplifiedMesh simplified(const TriangleMesh& mesh, const std::vector<bool>& wanted, std::size_t triangles,
                          const std::stop_token& stop = {});

} // namespace bolster
