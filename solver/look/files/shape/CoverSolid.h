// The cover as a body of its own: as thick as its material.
#pragma once

#include "CoverMesh.h"
#include "TriangleMesh.h"

namespace bolster {

/// The cover's outside, its inside `thickness` mm below, and a wall along every border: closed, each edge between
/// two triangles, which face outwards. Along edges where more than two patches meet each goes on as a sheet of its
/// own, a hair apart. Lengths mm, the design's axes. Without triangles there is nothing.
TriangleMesh coverSolid(const CoverMesh& cover, double thickness);

/// What closed triangles enclose, mm3; negative when they face inwards.
double enclosedVolume(const TriangleMesh& mesh);

} // namespace bolster
