// Which voxels lie inside of a frame (paper, section 4.1: the grid f'').
#pragma once

#include "FrameBodies.h"
#include "VoxelGrid.h"
#include "WorkerPool.h"

#include <optional>
#include <stop_token>

namespace bolster {

/// Sets the voxels whose centres lie inside of a body: where its triangles wind around them more than half a time.
/// Openings close along the surface where that is just half. Of a closed body the crossings of rows are counted
/// (RowCrossings). Of an open one only voxels near triangles are looked at one by one; between them little changes,
/// and every eighth is looked at. False when there are none: the body is thinner than a voxel, or so open that it
/// has no inside.
bool fillInside(const FrameBody& body, Voxels& voxels, WorkerPool& pool, const std::stop_token& stop = {});

/// The same of a surface that may have gaps, but no openings: rows of voxels that leave it as often as they come in
/// are counted, the voxels of others are looked at one by one.
void fillWithin(const TriangleTree& surface, Voxels& voxels, WorkerPool& pool, const std::stop_token& stop = {});

/// Whether there are any on a grid of this edge (mm); nothing when that is not known
/// after looking at so many voxels as are left; `looks` counts down.
std::optional<bool> hasInside(const FrameBody& body, double edge, int& looks);

} // namespace bolster
