// What the 3D view draws on: OpenGL, or software where there is none.
#pragma once

#include "Camera.h"
#include "ViewScene.h"

#include <QImage>

#include <chrono>
#include <functional>
#include <utility>

class QWidget;

namespace bolster {

/// Draws a scene with a camera; both belong to the view, which says when they have changed.
class SceneCanvas {
public:
    SceneCanvas(const ViewScene& scene, const Camera& camera)
        : m_scene(scene)
        , m_camera(camera)
    {}
    virtual ~SceneCanvas() = default;

    virtual QWidget& widget() = 0;
    /// Draws anew. `moving`: more of this comes soon, so quickly rather than finely.
    virtual void refresh(bool moving) = 0;
    /// Whether it draws the shadows that the scene brings.
    virtual bool drawsOcclusion() const = 0;
    /// The cover in the picture that is on the screen, or null: pictures come later than what they show.
    virtual SurfaceMeshPtr shown() const = 0;
    /// To be called when that is another one than before.
    void whenShownChanges(std::function<void()> tell) { m_tell = std::move(tell); }
    /// Pictures stay as quick as while something moves: for slow machines and screens far away.
    void setReduced(bool reduced)
    {
        if (std::exchange(m_reduced, reduced) != reduced)
            refresh(false);
    }
    /// The finest picture, now.
    virtual QImage grab() = 0;

protected:
    /// After the last movement the finest picture is drawn.
    static constexpr std::chrono::milliseconds restAfter{180};

    void tellShown() const
    {
        if (m_tell)
            m_tell();
    }

    bool reduced() const { return m_reduced; }

    const ViewScene& m_scene;
    const Camera& m_camera;

private:
    bool m_reduced = false;
    std::function<void()> m_tell;
};

} // namespace bolster
