// The 3D view: the cover over its frame, with fixation curves that can be dragged.
#pragma once

#include "Camera.h"
#include "DesignFile.h"
#include "SoftwareRenderer.h"
#include "SurfaceMesh.h"

#include <QImage>
#include <QWidget>

#include <memory>
#include <optional>

namespace bolster {

class Document;
class Selection;

class SurfaceView : public QWidget {
    Q_OBJECT

public:
    using StandardView = Camera::StandardView;

    /// What can be shown and hidden.
    enum class Layer { Cover, Checker, MeshEdges, Seams, Frames, FixationCurves, Ground };
    Q_ENUM(Layer)

    enum class Drawing {
        Automatic, ///< OpenGL where it works
        Software
    };

    SurfaceView(Document& document, Selection& selection, QWidget* parent = nullptr);
    ~SurfaceView() override;

    /// To be handed in before the view is shown; without one a view without OpenGL shows curves only.
    void setSoftwareRenderer(std::unique_ptr<SoftwareRenderer> renderer);
    /// Before the view is shown.
    void setDrawing(Drawing drawing);

    /// The cover to show; null for none. Cheap while the topology stays.
    void setSurface(SurfaceMeshPtr surface);
    SurfaceMeshPtr surface() const;
    /// The meshes of the design's frames; their placement is taken from the design.
    void setFrames(const FrameMeshes& frames);
    /// The surface is not up to date, or the last good one before a failure.
    void setDimmed(bool dimmed);

    void fitAll();
    void fitSelection();
    /// Turns smoothly and fits the whole scene.
    void setStandardView(bolster::SurfaceView::StandardView view);
    void setPerspective(bool perspective);
    bool perspective() const;
    const Camera& camera() const;
    void setCamera(const Camera& camera);

    void setLayerVisible(bolster::SurfaceView::Layer layer, bool visible);
    bool layerVisible(bolster::SurfaceView::Layer layer) const;

    /// What the view shows now, in device pixels, drawn finely.
    QImage grabPicture();
    /// What can be done now, for the status bar.
    QString prompt() const;

signals:
    void promptChanged(const QString& prompt);
    /// Where the pointer touches the cover, mm; nothing beside it.
    void pointerMoved(const std::optional<bolster::Vec3>& point);
    /// "No OpenGL: drawn in software", or "".
    void rendererNote(const QString& note);
    void perspectiveChanged(bool perspective);
    /// What a tool could not do, in the user's words.
    void failed(const QString& message);

private:
    Document& m_document;
    Selection& m_selection;
    SurfaceMeshPtr m_surface;
    Camera m_camera;
};

} // namespace bolster
