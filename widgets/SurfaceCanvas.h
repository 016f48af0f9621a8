// What the 3D view draws on: OpenGL, or software where there is none.
#pragma once

#include "SurfaceScene.h"

#include <QImage>

class QWidget;

namespace bolster {

/// Draws a scene with a camera; both belong to the view, which says when they have changed.
class SurfaceCanvas {
public:
    SurfaceCanvas(const SurfaceScene& scene, const Camera& camera)
        : m_scene(scene)
        , m_camera(camera)
    {}
    virtual ~SurfaceCanvas() = default;

    virtual QWidget& widget() = 0;
    /// Draws anew. `moving`: more of this comes soon, so quickly rather than finely.
    virtual void refresh(bool moving) = 0;
    /// Whether it draws the shadows that the scene brings.
    virtual bool drawsOcclusion() const = 0;
    /// The cover in the picture that is on the screen, or null: pictures come later than what they show.
    virtual SurfaceMeshPtr shown() const = 0;
    /// The finest picture, now.
    virtual QImage grab() = 0;

protected:
    const SurfaceScene& m_scene;
    const Camera& m_camera;
};

} // namespace bolster
