// Lines and handles painted over a picture without OpenGL.
#pragma once

#include "Camera.h"
#include "ViewScene.h"

class QPainter;

namespace bolster {

/// `depth` belongs to the picture underneath, `depthSize` pixels wide and high; empty: nothing hides anything.
/// The camera's size is that of the painted area.
void paintMarks(QPainter& painter, const ViewScene& scene, const Camera& camera, const std::vector<float>& depth,
                const Eigen::Vector2i& depthSize);

} // namespace bolster
