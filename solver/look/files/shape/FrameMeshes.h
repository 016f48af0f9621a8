// A frame's skin as a mesh whose corners share points.
#pragma once

#include "CoverModel.h"
#include "FrameSkin.h"

#include <functional>

namespace bolster {

/// Corners with one position and one normal become one point. Triangles whose corners are all hidden are left out.
ModelMesh frameMesh(const FrameSkin& skin, const std::function<bool(const Eigen::Vector3f&)>& hidden);

/// Of unit length; `other` where it has no direction.
Eigen::Vector3f unitOr(const Eigen::Vector3f& normal, const Eigen::Vector3f& other);

} // namespace bolster
