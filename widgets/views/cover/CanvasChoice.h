// The canvas of the 3D view: with OpenGL where it works, else in software.
#pragma once

#include "LatestJob.h"
#include "SceneCanvas.h"
#include "SoftwareRenderer.h"

#include <QObject>

#include <memory>

namespace bolster {

class CanvasChoice : public QObject {
    Q_OBJECT

public:
    enum class Drawing {
        Automatic, ///< OpenGL where it works
        Software
    };

    /// All must outlive it.
    CanvasChoice(const ViewScene& scene, const Camera& camera, QWidget& view);
    ~CanvasChoice() override;

    /// Both before the canvas is made; without a renderer a view without OpenGL shows curves only.
    void setSoftwareRenderer(std::unique_ptr<SoftwareRenderer> renderer);
    void setDrawing(Drawing drawing) { m_drawing = drawing; }
    /// As SceneCanvas has it.
    void setReduced(bool reduced);
    /// Unless it is there.
    void make();
    /// The same, but the window does not wait for the libraries of OpenGL.
    void makeSoon();
    bool made() const { return m_canvas != nullptr; }
    /// While something lies over the view nothing is drawn.
    void setCovered(bool covered);

    /// Fills the view.
    void place();
    /// Draws anew; see SceneCanvas.
    void refresh(bool moving);
    /// The cover in the picture that is on the screen: an earlier one for a moment. May be null.
    SurfaceMeshPtr shown() const { return m_canvas ? m_canvas->shown() : nullptr; }
    /// Whether the picture on the screen, if there is one, is of what the scene shows.
    bool upToDate() const { return !m_canvas || m_canvas->shown() == m_scene.surface; }
    /// What the view shows now, in device pixels, drawn finely.
    QImage grab();

signals:
    /// Another one; it draws soft shadows, or finds its own.
    void changed(bool drawsShadows);
    /// "No OpenGL: drawn in software", or "".
    void note(const QString& text);
    /// Another cover is in the picture on the screen.
    void pictured();

private:
    void use(std::unique_ptr<SceneCanvas> canvas);
    void useSoftware(const QString& why);

    const ViewScene& m_scene;
    const Camera& m_camera;
    QWidget& m_view;
    std::shared_ptr<SoftwareRenderer> m_renderer;
    Drawing m_drawing = Drawing::Automatic;
    bool m_reduced = false;
    bool m_covered = false;
    std::unique_ptr<SceneCanvas> m_canvas;
    std::unique_ptr<LatestJob<bool, bool>> m_loading;
};

} // namespace bolster
