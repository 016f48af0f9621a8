// Triangulates the inside of an outline (paper, section 3.2) without splitting its edges, along the curves drawn in
// it (section 3.5).
#pragma once

#include "Geometry.h"

#include <array>
#include <vector>

namespace bolster {

/// A polyline inside a patch that the triangles must follow. Its ends may be samples of the outline.
struct InnerLine {
    std::vector<Vec2> points; ///< outline coordinates, mm; of a closed line the first one is not repeated
    bool closed = false;
    int startSample = -1; ///< the sample of the outline that is its first point, or -1
    int endSample = -1;

    friend bool operator==(const InnerLine&, const InnerLine&) = default;
};

/// A flat mesh in outline coordinates, mm. The first vertices are the outline's samples in their order.
struct PatchMesh {
    std::vector<Vec2> points;
    std::vector<std::array<int, 3>> triangles; ///< counter-clockwise in the pattern plane
    int boundaryCount = 0;
    std::vector<std::vector<int>> lines; ///< the vertices along each inner line; a closed one ends where it begins
};

/// Hexagonal seed points, constrained Delaunay triangulation and a little smoothing. Keeps the boundary exactly, so
/// that seams still match, and the lines. The boundary may run either way; empty triangles if it crosses itself, or
/// a line crosses or touches it or another one elsewhere than in a sample that both name.
PatchMesh triangulatePatch(const std::vector<Vec2>& boundary, double edgeLength,
                           const std::vector<InnerLine>& lines = {});

} // namespace bolster
