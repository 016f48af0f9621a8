// How deep voxels lie (paper, section 4.1: the grid f').
#pragma once

#include "VoxelGrid.h"
#include "WorkerPool.h"

#include <cstdint>
#include <stop_token>

namespace bolster {

enum class VoxelMetric {
    CityBlock, ///< steps to neighbours with a common face; two sweeps along each axis
    Euclidean  ///< exact; Felzenszwalb and Huttenlocher, "Distance Transforms of Sampled Functions", 2012
};

/// For each voxel the distance from its centre to that of the nearest voxel with the value `goal`, in voxels; 1e6
/// and more if there is none. When stopped the result means nothing.
std::vector<float> distancesTo(std::uint8_t goal, const Voxels& voxels, VoxelMetric metric, WorkerPool& pool,
                               const std::stop_token& stop = {});

} // namespace bolster
