// The 3D view drawn with OpenGL.
#pragma once

#include "GlPainter.h"
#include "LatestJob.h"
#include "SceneCanvas.h"

#include <QOffscreenSurface>
#include <QTimer>
#include <QWidget>

namespace bolster {

/// Quick while something moves, with fewer pixels where OpenGL is slow; finer and finer when it rests. Pictures
/// come from a thread of their own, so the window never waits for them.
class GlCanvas : public QWidget, public SceneCanvas {
    Q_OBJECT

public:
    GlCanvas(const ViewScene& scene, const Camera& camera, QWidget* parent);
    ~GlCanvas() override;

    QWidget& widget() override { return *this; }
    void refresh(bool moving) override;
    bool drawsOcclusion() const override { return true; }
    SurfaceMeshPtr shown() const override { return m_picture.surface; }
    QImage grab() override;

signals:
    /// OpenGL was promised, but does not work.
    void failed(const QString& problem);

protected:
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    using Job = LatestJob<GlPainter::Request, GlPainter::Picture>;

    GlPainter::Request request() const;
    void schedule();
    void send();
    void received(GlPainter::Picture picture);
    QSize pixelSize() const;

    QOffscreenSurface m_surface; ///< that the painter's context needs; only this thread may make it
    GlPainter::Picture m_picture;
    std::uint64_t m_version = 0; ///< of what is to be seen
    bool m_moving = false;
    bool m_scheduled = false;
    std::optional<std::uint64_t> m_asked; ///< version of the picture that is on its way
    bool m_askedMoving = false;
    QTimer m_rest; ///< until the picture gets finer
    std::unique_ptr<Job> m_job;
};

} // namespace bolster
