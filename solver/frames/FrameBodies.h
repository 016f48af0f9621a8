// What is solid in a mesh: real frames have open edges, several parts that overlap, and faces turned the wrong way.
#pragma once

#include "Placement.h"
#include "TriangleMesh.h"
#include "TriangleTree.h"

#include <memory>
#include <optional>
#include <stop_token>

namespace bolster {

/// Triangles that enclose something together, oriented outwards as well as can be told.
struct FrameBody {
    TriangleTree tree;
    bool closed = false; ///< no open edges: the winding number only changes at triangles
    /// Twice the volume over the area, mm: of a board its thickness, of a rod its radius. Nothing of open ones.
    std::optional<double> thickness;
};

/// The bodies of each part of a mesh.
using FrameParts = std::vector<std::vector<FrameBody>>;

/// Each point p as placement.placed(p). Corners of a part in the same place are one; what hangs together gets one
/// orientation. Each closed shell is a body, so that shells that overlap or lie inside of each other make no holes.
/// All open shells together are another body, each turned away from their middle: walls modelled one by one close
/// it together. Open walls that reach into a body stay wrong where they do. When stopped, bodies are missing.
FrameParts frameParts(const TriangleMesh& mesh, const Placement& placement, const std::stop_token& stop = {});

} // namespace bolster
