// While something moves, meshes of more triangles than a slow OpenGL can draw in time are shown with fewer.
#pragma once

#include "FrameSkin.h"
#include "SurfaceMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bolster {

/// What whoever draws on processors can draw some thirty times a second.
constexpr std::size_t mostMovingTriangles = 100'000;
/// Whether there are so many that fewer are worth making.
constexpr bool tooManyToMove(std::size_t triangles)
{
    return triangles > mostMovingTriangles + mostMovingTriangles / 2;
}

/// Fewer triangles on the same vertices, patch by patch.
struct FewerTriangles {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::size_t> firstOf; ///< of each patch of the topology, and their end
};

/// About `most`: of the vertices inside a patch one stays in each square of its pattern, and all of its outline, so
/// that no gaps open at seams.
FewerTriangles fewerTriangles(const SurfaceTopology& topology, std::size_t most);

/// About `most` triangles: corners that lie near each other and look the same way become one.
std::vector<FrameSkin::Corner> fewerCorners(const std::vector<FrameSkin::Corner>& corners, std::size_t most);

} // namespace bolster
