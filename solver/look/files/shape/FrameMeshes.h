// A frame's skin as a mesh whose corners share points.
#pragma once

#include "CoverModel.h"
#include "FrameSkin.h"

namespace bolster {

/// Corners with one position and one normal become one point.
ModelMesh frameMesh(const FrameSkin& skin);

/// Of unit length; `other` where it has no direction.
Eigen::Vector3f unitOr(const Eigen::Vector3f& normal, const Eigen::Vector3f& other);

} // namespace bolster
