// How fine the voxels of cushioning can be: there must not be too many of them.
#pragma once

#include "Cushion.h"
#include "Frame.h"
#include "TriangleMesh.h"

namespace bolster {

/// Grids with more voxels than this are refused: about 700 MB while they are made.
inline constexpr double mostVoxels = 2.4e7;

/// How many voxels of this edge (mm) fill a box with `margin` of them around it; also where they could not be
/// counted in an int.
double voxelCount(const Box3& box, double edge, int margin);
/// Of them cushioning has so many around what it fills.
inline constexpr int cushionMargin = 5;

/// The finest voxels (mm) for cushioning around a mesh: those that are usual, or coarser ones in steps of half a
/// millimetre. All of the mesh is taken, or the parts that the cushion names; foam may need coarser ones.
double fittingVoxel(const Cushion& cushion, const Frame& frame, const TriangleMesh& mesh);

} // namespace bolster
