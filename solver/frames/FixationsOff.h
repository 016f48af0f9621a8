// Which fixation curves a frame leaves behind when its file is replaced by another one.
#pragma once

#include "Design.h"
#include "TriangleMesh.h"

#include <memory>
#include <stop_token>
#include <vector>

namespace bolster {

/// A mesh where it stands in the design.
struct PlacedMesh {
    std::shared_ptr<const TriangleMesh> mesh; ///< may be null: there is no such mesh
    Placement placement;
    std::vector<std::vector<Vec3>> edges = {}; ///< file units: along which curves may run
};

/// A fixation curve that lay on the mesh of before, as a whole or in parts.
struct FixationOff {
    ElementId curve = noElement;
    double distance = 0; ///< mm, from the farthest of those places of it to the new mesh; at most `farthestLooked`
    bool fromEdge = false; ///< it ran along an edge: so far is the nearest edge of the new mesh
};

inline constexpr double liesOnFrame = 1; ///< mm: a place of a curve that near to a mesh, or an edge, lies on it
inline constexpr double farthestLooked = 500; ///< mm: beyond that it does not matter how far

/// Curves of which places that lay on `before` lie farther than `liesOnFrame` from `after`; the farthest first. Of
/// curves that ran along edges, as a whole, the edges are compared.
/// Empty when stopped, and when one of the meshes is not there.
std::vector<FixationOff> fixationsOff(const Design& design, const PlacedMesh& before, const PlacedMesh& after,
                                      const std::stop_token& stop = {});

} // namespace bolster
