// The solver's state as the value that views and exports read.
#pragma once

#include "SewnMesh.h"
#include "SheetState.h"

namespace bolster {

/// With the reliefs of fancy seams. Vertex normals are smooth within a patch and point outside.
SurfaceMeshPtr makeSurface(const SewnMesh& mesh, const SheetState& state, std::uint64_t revision);

} // namespace bolster
