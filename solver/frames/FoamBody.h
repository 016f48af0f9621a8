// The shapes of foam as solids.
#pragma once

#include "FrameFields.h"

namespace bolster {

/// The bodies of a foam's mesh where it is placed; none for other shapes.
FrameParts foamParts(const FrameFields::FoamKey& foam, const std::stop_token& stop);
/// In the frame's axes.
Box3 foamBox(const FrameFields::FoamKey& foam);
std::shared_ptr<const Voxels> foamVoxels(const FrameFields::FoamKey& foam, double edge, WorkerPool& pool,
                                         const std::stop_token& stop);

} // namespace bolster
