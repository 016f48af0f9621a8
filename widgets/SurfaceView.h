// The 3D view: the cover over its frame, with fixation curves that can be dragged.
#pragma once

#include "Camera.h"
#include "CoverPlaces.h"
#include "DesignFile.h"
#include "FieldPicture.h"
#include "FoamMeshes.h"
#include "MapLegend.h"
#include "ScanPoints.h"
#include "SectionHandle.h"
#include "SoftwareRenderer.h"
#include "SurfaceCanvas.h"
#include "SurfaceHit.h"
#include "SurfaceJob.h"
#include "SurfaceTools.h"
#include "ToolKey.h"
#include "VisibleCover.h"

#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <QVariantAnimation>
#include <QWidget>

#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <set>

namespace bolster {

class Document;
class Crosshair;
class PointerNote;
class SectionPanel;
class Selection;
class SurfaceViewCube;

/// The middle or right button, or Alt with the left one, turns; with Shift it pans. The left button turns, too,
/// where there is nothing to drag. The wheel zooms at the pointer; Home shows everything.
class SurfaceView : public QWidget, private SurfaceToolContext {
    Q_OBJECT

public:
    using StandardView = Camera::StandardView;

    /// What can be shown and hidden.
    enum class Layer {
        Cover,
        Checker,
        MeshEdges,
        Seams,
        Frames,
        FixationCurves,
        HandleCurves,
        FancySeams,
        Scans,
        ScanPairs,
        ScanColors, ///< of scans whose points have colours of their own
        Ground,
        Field,
        Twins,   ///< the mirror image of what is selected
        Symmetry ///< the plane
    };
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
    SurfaceMeshPtr surface() const { return m_surface; }
    /// The same refined, to be drawn in its place; not taken when another surface is shown meanwhile.
    /// `trims`: stitches and piping on it; may be null.
    void setCover(bolster::CoverMeshPtr cover, bolster::TrimMeshPtr trims = {});
    /// What fabrics look like; those that are not listed are plain.
    void setFabricMaps(std::map<bolster::ElementId, bolster::FabricMapsPtr> maps);
    /// The cover in the picture that is on the screen: an earlier one for a moment. May be null.
    SurfaceMeshPtr shownSurface() const { return m_canvas ? m_canvas->shown() : nullptr; }
    /// Whether the picture on the screen, if there is one, is of this surface.
    bool pictures(const SurfaceMeshPtr& surface) const
    {
        return !isVisible() || !m_canvas || (m_surface == surface && m_canvas->shown() == m_scene.surface);
    }
    /// What the design's files hold: frames, foam and scans; their placement is taken from the design.
    void setFiles(const DesignFiles& files);
    /// Colours on the cover; null for none.
    void setMap(SurfaceMapPtr map);
    /// What the map says under the pointer.
    void setMapReading(const QString& reading);
    /// Which points of a scan belong to which places of the cover, mm: shown as lines.
    /// Whether points of some scan have colours of their own.
    bool hasScanColors() const { return m_scanPoints.hasColors(); }
    void setScanPairs(std::vector<std::pair<Vec3, Vec3>> pairs);
    /// A box around these pieces of a frame (FramePieces), hidden or not; without any: none.
    void showFramePieces(bolster::ElementId frame, const std::vector<int>& pieces);
    void setTool(bolster::SurfaceToolKind kind);
    SurfaceToolKind tool() const { return m_toolKind; }
    /// The next drag cuts away, or keeps, a part of the scan.
    void startScanCut(bolster::ElementId scan, bool keep);
    /// The forces of cushioning; null for none. Shown in their layer.
    void setField(FieldPicturePtr field);
    /// The surface is not up to date, or the last good one before a failure.
    void setDimmed(bool dimmed);

    double floorHeight() const { return m_scene.floor; } ///< mm
    /// All of the box can be seen, but for what stands in front of it.
    bool inPicture(const Box3& box) const;
    void fitAll();
    void fitSelection(); ///< everything when nothing that is shown is selected
    /// Turns smoothly and fits the whole scene.
    void setStandardView(bolster::SurfaceView::StandardView view);
    void setPerspective(bool perspective);
    bool perspective() const { return m_camera.perspective; }
    const Camera& camera() const { return m_camera; }
    void setCamera(const Camera& camera);
    /// Turns smoothly; the size of the picture stays.
    void flyTo(const Camera& camera);
    /// The view of a design that is opened again: what appears in it by and by does not move it.
    void returnTo(const Viewpoint& view);
    bool hasReturned() const { return m_returned; }

    void setLayerVisible(bolster::SurfaceView::Layer layer, bool visible);
    bool layerVisible(bolster::SurfaceView::Layer layer) const { return m_layers.contains(layer); }

    /// What is not shown, until it is shown again; not a part of the design.
    void setHidden(std::set<bolster::ElementId> hidden);
    const std::set<ElementId>& hidden() const { return m_hidden; }
    /// Cuts open what is shown; a panel in the corner moves the plane.
    void setSectionShown(bool shown);
    /// Nothing: not cut open.
    void setSection(const std::optional<bolster::SectionPlane>& section);
    const std::optional<SectionPlane>& section() const { return m_scene.section; }
    /// 0 to 1: frames and foam over a cover, usually 0.45; points of scans, usually 1.
    void setFrameOpacity(double opacity);
    void setScanOpacity(double opacity);
    /// A cross-hair where the point lies on the cover; nothing takes it away.
    void showPlace(const std::optional<bolster::CoverPoint>& point);
    /// Moves the picture if the point is not in it.
    void reveal(const bolster::CoverPoint& point);

    /// What the view shows now, in device pixels, drawn finely.
    QImage grabPicture();
    /// What can be done now, for the status bar.
    QString prompt() const;
    SurfaceHit hit(QPointF pixel) const override;
    QSize sizeHint() const override { return {760, 640}; }

signals:
    void promptChanged(const QString& prompt);
    /// Where the pointer touches the cover, mm; nothing beside it.
    void pointerMoved(const std::optional<bolster::Vec3>& point);
    /// The point of the pattern under the pointer; nothing beside the cover.
    void coverPointed(const std::optional<bolster::CoverPoint>& point);
    /// Clicked with the tool that selects.
    void coverClicked(const bolster::CoverPoint& point);
    void hiddenChanged();
    /// Another cover is in the picture on the screen.
    void pictured();
    void sectionClosed();
    /// "No OpenGL: drawn in software", or "".
    void rendererNote(const QString& note);
    void perspectiveChanged(bool perspective);
    /// Turned, moved or zoomed.
    void cameraMoved(const bolster::Camera& camera);
    void toolChanged(bolster::SurfaceToolKind kind);
    /// By a click with the right button or the menu key; what lies there is selected then.
    void contextMenuWanted(const QPoint& global, bool onSomething);
    /// Instead, while a tool has begun something.
    void toolMenuWanted(const QPoint& global, const bolster::ToolKeys& keys);
    /// What a tool could not do, in the user's words.
    void failed(const QString& message);

protected:
    bool event(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
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
    enum class Navigation { None, Turn, Pan };

    Document& document() override { return m_document; }
    Selection& selection() override { return m_selection; }
    const Camera& toolCamera() const override { return m_camera; }
    const ViewColors& colors() const override { return m_scene.colors; }
    void refresh() override;
    void report(const QString& problem) override { emit failed(problem); }
    void endTool() override;
    bool handle(QEvent* event);
    void toolFailed(const std::exception& error);

    void makeCanvas();
    void useSoftware(const QString& note);
    void designChanged(const std::set<bolster::ElementId>& ids);
    SurfaceHit ground(QPointF pixel) const override { return m_hitTest.hitGround(m_camera, pixel); }
    std::optional<SurfaceFoot> nearest(const Vec3& point, SurfaceHit::Kind on) const override
    {
        return m_hitTest.nearest(point, on);
    }
    void updateFrames();
    Vec3 middleOf(ElementId id) const override;
    void updateScans();
    void addScanPairs();
    void addFramePieces();
    void updateLooks();
    void updateMarks();
    void updateMirrored();
    void updateCurves();
    void updateCover();
    std::set<ElementId> unseen() const;
    void cutMarks();
    void cutPoints();
    bool pressSection(const QMouseEvent& event);
    bool moveSection(const QMouseEvent& event);
    bool releaseSection(const QMouseEvent& event);
    bool cancelSection();
    void sectionHandleChanged();
    void placeCrosshair();
    std::optional<CoverPoint> coverPointOf(const SurfaceHit& solid) const;
    void updateBox();
    double floorUnder(const Box3& shown);
    void draw(bool moving);
    void requestOcclusion();
    /// What of frames is seen beside the cover; made beside the GUI thread.
    struct Skins {
        SurfaceMeshPtr surface; ///< may be null
        std::vector<Scene::FrameLook> frames;
        std::vector<ElementId> ids; ///< of the frames
    };
    struct MadeSkin {
        std::shared_ptr<const TriangleMesh> mesh;
        SurfaceMeshPtr cover; ///< under which it is pressed; may be null
        FrameSkinPtr skin;
    };
    static Skins skinsOf(const Skins& wanted, std::stop_token stop);
    void requestSkins();
    void takeSkins(const Skins& made);
    const MadeSkin* skinOf(std::size_t frame) const;
    void useSkins();
    void keepSkins();

    void apply(const Camera& camera);
    void goTo(Camera camera);
    Camera destination() const;
    Box3 selectedBox() const;
    double frontSide() const;
    void startNavigation(Navigation navigation, QPointF pixel);
    void navigate(QPointF pixel);
    Vec3 anchorAt(QPointF pixel) const;

    Document& m_document;
    Selection& m_selection;
    std::shared_ptr<SoftwareRenderer> m_softwareRenderer;
    Drawing m_drawing = Drawing::Automatic;
    std::set<Layer> m_layers;

    SurfaceMeshPtr m_surface;
    CoverMeshPtr m_cover; ///< of another surface: not drawn
    TrimMeshPtr m_trims;  ///< on m_cover
    FieldPicturePtr m_field;
    DesignFiles m_files;
    SurfaceScene m_scene;
    SurfaceCurves m_curves;
    std::set<ElementId> m_hidden;
    std::set<ElementId> m_mirrored; ///< of what is selected or under the pointer
    VisibleCover m_visibleCover;
    CoverPlaces m_places; ///< on what is shown of the cover
    double m_scanOpacity = 1;
    FrameShapes m_frameShapes;
    Box3 m_frameBox;          ///< mm
    Box3 m_standing;          ///< the same while the frame is hidden, too
    ElementId m_pieceFrame{}; ///< whose pieces are marked
    std::vector<int> m_pieces;
    std::vector<ElementId> m_frameIds; ///< of the scene's frames: frames, then foam
    FoamMeshes m_foamMeshes;
    std::map<ElementId, std::vector<MadeSkin>> m_skins; ///< of frames and foam, of hidden ones, too; newest first
    bool m_skinsFit = true; ///< those shown were made where the frames are now, under what is shown of the cover
    ScanPoints m_scanPoints;
    std::vector<std::pair<Vec3, Vec3>> m_scanPairs; ///< on the cover, and of the scan
    SurfaceHitTest m_hitTest{m_frameShapes};
    Camera m_camera;
    SectionHandle m_sectionHandle{m_scene, m_camera};

    std::unique_ptr<SurfaceCanvas> m_canvas;
    SurfaceViewCube* m_cube;
    MapLegend* m_legend;
    SectionPanel* m_sectionPanel;
    Crosshair* m_crosshair;
    PointerNote* m_note;
    std::optional<CoverPoint> m_shown; ///< the place of the cross-hair in its patch
    std::optional<Vec3> m_place;       ///< and on the cover, mm
    void rightClick(const QMouseEvent& event);
    void wantMenu(const QPoint& global, bool onSomething);

    QPointF m_pressedAt; ///< the left button
    SurfaceToolKind m_toolKind = SurfaceToolKind::Select;
    std::unique_ptr<SurfaceTool> m_tool;
    QString m_prompt;
    std::optional<std::pair<ElementId, int>> m_hoveredPoint;
    bool m_guided = false;    ///< the tool's guides are among the lines
    bool m_fitPending = true; ///< until there is something to see and a size
    bool m_returned = false;  ///< the view was given, and no other was asked for since

    Navigation m_navigation = Navigation::None;
    Qt::MouseButton m_navigationButton = Qt::NoButton;
    QPointF m_navigationLast;
    Vec3 m_navigationAnchor = Vec3::Zero();
    QVariantAnimation m_flight;
    Camera m_flightFrom, m_flightTo;

    QElapsedTimer m_sinceSurface;
    QTimer m_occlusionDelay;
    SurfaceJob<SurfaceOcclusion::Input, std::shared_ptr<const SurfaceOcclusion>> m_occlusionJob;
    SurfaceJob<Skins, Skins> m_skinJob;
};

} // namespace bolster
