// The surface where numbers on a grid change their sign.
#pragma once

#include "TriangleMesh.h"
#include "VoxelGrid.h"

#include <stop_token>

namespace bolster {

/// Marching tetrahedra: six to a cube, the same way in all cubes, so that the surface is closed where the values at
/// the border of the grid are below zero: each edge lies between two triangles, which face to where values are
/// below zero. `values`: one for each centre of a voxel.
TriangleMesh isoSurface(const VoxelGrid& grid, const std::vector<float>& values, const std::stop_token& stop = {});

} // namespace bolster
