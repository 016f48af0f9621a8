// Triangulates the inside of an outline (paper, section 3.2) without splitting its edges.
#pragma once

#include "Geometry.h"

#include <array>
#include <vector>

namespace bolster {

/// A flat mesh in outline coordinates, mm. The first vertices are the outline's samples in their order.
struct PatchMesh {
    std::vector<Vec2> points;
    std::vector<std::array<int, 3>> triangles; ///< counter-clockwise in the pattern plane
    int boundaryCount = 0;
};

/// Hexagonal seed points, constrained Delaunay triangulation and a little smoothing. Keeps the boundary exactly, so
/// that seams still match. The boundary may run either way; empty triangles if it crosses itself.
PatchMesh triangulatePatch(const std::vector<Vec2>& boundary, double edgeLength);

} // namespace bolster
