// What all parts of an OpenGL picture share: camera, light, size.
#pragma once

#include "Camera.h"
#include "GlProgram.h"
#include "ViewScene.h"

#include <QSize>

namespace bolster {

struct GlView {
    Eigen::Matrix4f view;
    Eigen::Matrix4f projection;
    Eigen::Vector2f viewport; ///< pixels of the picture
    float pixelRatio = 1;     ///< pixels of the picture per pixel of the widget
    float pixelAtOne = 1;     ///< mm per pixel at depth 1, or everywhere without perspective
    bool perspective = true;
    Eigen::Vector4f section = {0, 0, 0, 1}; ///< normal and offset of the plane beyond which nothing is shown
    Eigen::Vector3f key, rim, up;           ///< directions to the lights and upwards, eye coordinates

    /// `jitter`: by how much the picture is moved, pixels.
    GlView(const ViewScene& scene, const Camera& camera, const QSize& size, const Vec2& jitter);

    void setTransforms(GlProgram& program) const;
    void setLights(GlProgram& program) const;
    void setPixels(GlProgram& program) const;
};

} // namespace bolster
