// The 3D view where there is no OpenGL: pictures come from a renderer on a thread of its own, lines are painted
// over.
#pragma once

#include "LatestJob.h"
#include "SceneCanvas.h"
#include "SoftwareRenderer.h"

#include <QTimer>
#include <QWidget>

#include <memory>
#include <mutex>
#include <optional>

namespace bolster {

/// Small pictures while something moves, the whole size when it rests; the newest wins.
class SoftwareCanvas : public QWidget, public SceneCanvas {
    Q_OBJECT

public:
    /// Without a renderer only background and lines are drawn.
    SoftwareCanvas(const ViewScene& scene, const Camera& camera, std::shared_ptr<SoftwareRenderer> renderer,
                   QWidget* parent);
    ~SoftwareCanvas() override;

    QWidget& widget() override { return *this; }
    void refresh(bool moving) override;
    bool drawsOcclusion() const override { return false; } ///< the renderer finds its own
    SurfaceMeshPtr shown() const override { return m_picture.request.scene.surface; }
    QImage grab() override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Picture {
        SoftwareRenderer::Request request;
        SoftwareRenderer::Picture result;
    };

    SoftwareRenderer::Request request(bool moving) const;
    void send(bool moving);
    void received(Picture picture);
    bool fine() const;
    void paintPicture(QPainter& painter, const Picture& picture, const Camera& camera) const;

    std::shared_ptr<SoftwareRenderer> m_renderer;
    Picture m_picture;
    std::optional<SoftwareRenderer::Request> m_asked; ///< the picture that is on its way
    bool m_again = false;                             ///< something has changed since a quick one was asked for
    QTimer m_rest;
    std::mutex m_rendering; ///< the renderer takes one call at a time
    std::unique_ptr<LatestJob<SoftwareRenderer::Request, Picture>> m_job;
};

} // namespace bolster
