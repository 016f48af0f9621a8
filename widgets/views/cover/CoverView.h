// The 3D view: the cover over its frame, with fixation curves that can be dragged.
#pragma once

#include "CameraDrag.h"
#include "CanvasChoice.h"
#include "CoverCrosshair.h"
#include "CoverMeasures.h"
#include "CoverNavigation.h"
#include "CoverToolHost.h"
#include "SceneVisibility.h"
#include "SectionControl.h"
#include "ShownMap.h"
#include "ShownScene.h"

#include <QImage>
#include <QWidget>

#include <memory>
#include <optional>

namespace bolster {

class MapLegend;
class ViewCube;

/// Which buttons turn, pan and zoom says MouseStyle. The left button turns, too, where there is nothing to drag.
/// Home shows everything.
class CoverView : public QWidget {
    Q_OBJECT

public:
    using StandardView = Camera::StandardView;
    using Layer = SceneVisibility::Layer;
    using Drawing = CanvasChoice::Drawing;

    CoverView(Document& document, Selection& selection, QWidget* parent = nullptr);
    ~CoverView() override;

    /// What is shown: cover, files, section ...
    ShownScene& shown() { return m_shown; }
    const ShownScene& shown() const { return m_shown; }
    /// Which parts of it.
    SceneVisibility& visibility() { return m_visibility; }
    /// From where.
    CoverNavigation& navigation() { return m_navigation; }
    const CoverNavigation& navigation() const { return m_navigation; }

    /// Both before the view is shown; without a renderer a view without OpenGL shows curves only.
    void setSoftwareRenderer(std::unique_ptr<SoftwareRenderer> renderer);
    void setDrawing(Drawing drawing);
    /// Something lies over the view: nothing is drawn until it is seen.
    void setCovered(bool covered);
    /// It has something to draw on: not before it was seen.
    bool draws() const { return m_canvas.made(); }
    /// Quick pictures, also when nothing moves; at any time.
    void setReduced(bool reduced) { m_canvas.setReduced(reduced); }
    /// The cover in the picture that is on the screen: an earlier one for a moment. May be null.
    SurfaceMeshPtr shownSurface() const { return m_canvas.shown(); }
    /// Whether the picture on the screen, if there is one, is of this surface.
    bool pictures(const SurfaceMeshPtr& surface) const;
    /// What the view shows now, in device pixels, drawn finely.
    QImage grabPicture() { return m_canvas.grab(); }
    /// The same in other colours: on a light ground for paper.
    QImage grabPicture(const ViewColors& colors);
    /// The part of it that has the cover, with some room around and nothing marked; without a cover everything.
    QImage grabCover();

    /// Colours on the cover; null for none.
    void setMap(const bolster::ShownMapPtr& map);
    const ShownMapPtr& map() const;
    /// What the map says under the pointer.
    void setMapReading(const QString& reading);
    /// Cuts open what is shown; a panel in the corner moves the plane.
    void setSectionShown(bool shown) { m_section.setOn(shown); }
    /// A cross-hair where the point lies on the cover; nothing takes it away.
    void showPlace(const std::optional<bolster::CoverPoint>& point) { m_crosshair.show(point); }
    void setMeasurementsShown(bool shown) { m_measures->setWanted(shown); }
    /// Moves the picture if the point is not in it.
    void reveal(const bolster::CoverPoint& point);
    /// Turned so that it is seen from outside.
    void face(const bolster::CoverPoint& point);

    void setTool(bolster::CoverToolKind kind) { m_tools.setTool(kind); }
    CoverToolKind tool() const { return m_tools.kind(); }
    bool takeBack() { return m_tools.takeBack(); } ///< as ToolHost has it
    /// The next drag cuts away, or keeps, a part of the scan.
    void startScanCut(bolster::ElementId scan, bool keep) { m_tools.startScanCut(scan, keep); }
    /// The next clicks say where three places of the scan belong, `marks` those of them that were given before.
    void startScanAlign(bolster::ElementId scan, ScanAlignTool::Done done, std::vector<ScanMark> marks = {})
    {
        m_tools.startScanAlign(scan, std::move(done), std::move(marks));
    }
    /// Clicks make fixation curves of these edges.
    void startFrameEdges(OfferedEdgesPtr edges) { m_tools.startFrameEdges(std::move(edges)); }
    /// Drags over the cover paint an area, brush `radius` in mm.
    void startAreaBrush(double radius, AreaBrushTool::Take take)
    {
        m_tools.startAreaBrush(radius, std::move(take));
    }
    /// What can be done now, for the status bar.
    QString prompt() const { return m_tools.prompt(); }
    CoverHit hit(QPointF pixel) const { return m_tools.hit(pixel); }
    QSize sizeHint() const override { return {760, 640}; }

signals:
    void promptChanged(const QString& prompt);
    /// Where the pointer touches the cover, mm; nothing beside it.
    void pointerMoved(const std::optional<bolster::Vec3>& point);
    /// The point of the pattern under the pointer; nothing beside the cover.
    void coverPointed(const std::optional<bolster::CoverPoint>& point);
    /// Clicked with the tool that selects.
    void coverClicked(const bolster::CoverPoint& point);
    /// Of measurements on the cover, mm; when it has come to rest, and after edits.
    void measured(const std::map<bolster::ElementId, double>& lengths);
    /// Another cover is in the picture on the screen.
    void pictured();
    void sectionClosed();
    /// "No OpenGL: drawn in software", or "".
    void rendererNote(const QString& note);
    void toolChanged(bolster::CoverToolKind kind);
    /// By a click with the right button or the menu key; what lies there is selected then.
    void contextMenuWanted(const QPoint& global, bool onSomething);
    /// Instead, while a tool has begun something.
    void toolMenuWanted(const QPoint& global, const bolster::ToolKeys& keys);
    /// What a tool could not do, in the user's words.
    void failed(const QString& message);

protected:
    bool event(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void wireScene();
    void wireTools();
    void cameraMoved();
    void draw(bool moving);
    bool handle(QEvent* event);
    void startDrag(const QMouseEvent& event, Qt::MouseButton button);

    bool m_whole = false; ///< else what is in it comes or goes, and there are no tools to handle events
    bool m_covered = false;
    Selection& m_selection;
    SceneVisibility m_visibility;
    ShownScene m_shown;
    CoverNavigation m_navigation;
    CameraDrag m_drag;
    CanvasChoice m_canvas;
    SectionControl m_section;
    CoverCrosshair m_crosshair;
    CoverMeasures* m_measures;
    CoverToolHost m_tools;
    ViewCube* m_cube;
    MapLegend* m_legend;
    QPointF m_pressedAt; ///< the left button
};

} // namespace bolster
