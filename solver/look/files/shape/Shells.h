// The connected parts of a closed surface.
#pragma once

#include "TriangleMesh.h"

#include <vector>

namespace bolster {

struct Shell {
    std::vector<std::uint32_t> triangles; ///< of the mesh
    Box3 box;
    double volume = 0; ///< of the mesh's unit, cubed; negative: a void, whose triangles face inwards

    bool isVoid() const { return volume < 0; }
};

/// In the order of their first triangles.
std::vector<Shell> shellsOf(const TriangleMesh& solid);

/// Shells that enclose less than `volume`, bodies and voids, go, and so do points that are in no triangle then.
/// Returns how many bodies went. Of a mesh of one part.
std::size_t dropSmallShells(TriangleMesh& solid, double volume);

} // namespace bolster
