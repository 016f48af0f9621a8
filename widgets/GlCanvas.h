// The 3D view drawn with OpenGL.
#pragma once

#include "GlPicture.h"
#include "SurfaceCanvas.h"
#include "SurfaceRenderer.h"

#include <QOpenGLWidget>
#include <QTimer>

#include <memory>

namespace bolster {

/// Quick while something moves, with fewer pixels where OpenGL is slow; finer and finer when it rests.
class GlCanvas : public QOpenGLWidget, public SurfaceCanvas {
    Q_OBJECT

public:
    GlCanvas(const SurfaceScene& scene, const Camera& camera, QWidget* parent);
    ~GlCanvas() override;

    QWidget& widget() override { return *this; }
    void refresh(bool moving) override;
    bool drawsOcclusion() const override { return true; }
    QImage grab() override;

signals:
    /// OpenGL was promised, but does not work.
    void failed(const QString& problem);

protected:
    void initializeGL() override;
    void paintGL() override;

private:
    void release();
    void paintMoving(const QSize& size);
    void paintResting(const QSize& size);
    QSize pixelSize() const;

    std::unique_ptr<SurfaceRenderer> m_renderer;
    std::unique_ptr<GlPicture> m_picture;
    bool m_moving = false;
    bool m_fineAtOnce = false;
    double m_frameTime = 0.01; ///< of one frame of the whole size, seconds
    QTimer m_rest;             ///< until the picture gets finer
};

} // namespace bolster
