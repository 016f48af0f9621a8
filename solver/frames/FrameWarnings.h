// What voxels cannot find of a frame: cushioning and contact that would do nothing must not be silent about it.
#pragma once

#include "FrameFields.h"
#include "Problem.h"
#include "SolveInput.h"

namespace bolster {

/// What a frame shows of its file; null while that is not there.
TriangleMeshPtr meshOfFrame(const SolveInput& input, ElementId frame);

/// The first names of parts, in quotes, for messages; `chosen`: only these.
std::string partNames(const TriangleMesh& mesh);
std::string partNames(const TriangleMesh& mesh, const std::vector<int>& chosen);

/// Who looks at a frame through voxels: their edge can be chosen for a cushion, for contact it follows from the
/// frame.
enum class VoxelUser { Cushion, Contact };

/// When voxels of this edge (mm) are likely to miss these parts.
Message thinPartsMessage(VoxelUser user, const TriangleMesh& mesh, const std::vector<int>& thin, double edge);
/// When there are none at all.
Message noVoxelsMessage(VoxelUser user, double edge);

/// For each frame that hides parts which its file does not have.
void addUnknownParts(const SolveInput& input, Problems& problems);

/// Each of them looks at the whole cover in every iteration.
inline constexpr int mostCushions = 100;
/// Once, when more are enabled.
void addTooManyCushions(const SolveInput& input, Problems& problems);

/// What can be known of the frames under enabled cushions and of those with contact without looking for the parts
/// under each cover. Nothing of frames whose files are not there.
Problems checkFrames(const SolveInput& input);

} // namespace bolster
