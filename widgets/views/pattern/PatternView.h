// The pattern view: the patches in their layout, with seams and fixations.
#pragma once

#include "BackgroundPicture.h"
#include "CoverPlaces.h"
#include "MapLegend.h"
#include "PatternPainter.h"
#include "PatternTools.h"
#include "SurfaceMesh.h"
#include "ToolKey.h"

#include <QWidget>

#include <exception>
#include <memory>
#include <optional>

namespace bolster {

class Crosshair;
class PatternRuler;

/// The wheel zooms at the pointer; the middle button, or Space with the left one, pans; Home shows everything.
class PatternView : public QWidget, private PatternToolContext {
    Q_OBJECT

public:
    PatternView(Document& document, Selection& selection, ProblemSet& problems, QWidget* parent = nullptr);
    ~PatternView() override;

    /// Where the triangulation comes from; null for none.
    void setSurface(const SurfaceMeshPtr& surface);
    /// Colours on the patches; null for none.
    void setMap(const SurfaceMapPtr& map);
    /// What fabrics look like from far away, by their ids.
    void setFabricColors(std::map<bolster::ElementId, QColor> colors);
    /// What the map says under the pointer.
    void setMapReading(const QString& reading);
    /// Not beside another view that has one; shown at first.
    void setLegendShown(bool shown);
    /// Elements that the 3D view does not show.
    void setHidden(std::set<bolster::ElementId> hidden);
    PatternLayers layers() const { return m_layers; }
    void setLayers(const PatternLayers& layers);

    /// Whether drawing and dragging snap to what is near; off at first.
    bool snapping() const { return m_snap.on; }
    void setSnapping(bool on);
    /// Rulers along the edges; off at first.
    void setRulersShown(bool shown);
    /// Guides belong to the view, not to the design; those that are hidden do not snap.
    const PatternGuides& guides() const { return m_guides; }
    void setGuides(const PatternGuides& guides);
    void setGuidesShown(bool shown);
    /// A drag from nothing selects in a loop; with Alt it is the other way round.
    void setLasso(bool on) { m_lasso = on; }
    bool lasso() const override { return m_lasso; }
    const BackgroundPicture& background() const override { return m_background; }
    void setBackground(const BackgroundPicture& picture) override;

    void fitAll();
    void fitSelection(); ///< everything when nothing in the layout is selected
    const PatternTransform& transform() const override { return m_transform; }
    void setTransform(const PatternTransform& transform);

    void setTool(bolster::PatternToolKind kind);
    PatternToolKind tool() const { return m_toolKind; }

    /// A cross-hair at a point of a patch; nothing takes it away.
    void showPlace(const std::optional<bolster::CoverPoint>& point);
    /// Moves the picture if the point is not in it.
    void reveal(const bolster::CoverPoint& point);

    /// Without rulers and the scale bar: here something may lie over the view. Pixels.
    QRect freeRoom() const;
    QString prompt() const;
    PatternHit hit(QPointF pixel) const override;
    QSize sizeHint() const override { return {640, 640}; }

signals:
    void promptChanged(const QString& prompt);
    void toolChanged(bolster::PatternToolKind kind);
    /// There is more or less of it in a view of the same size.
    void freeRoomChanged();
    void pointerMoved(const std::optional<bolster::Vec2>& layout);
    /// Moved or zoomed.
    void transformChanged(const bolster::PatternTransform& transform);
    /// The point of a patch under the pointer; nothing beside them.
    void patchPointed(const std::optional<bolster::CoverPoint>& point);
    /// Clicked with the tool that selects.
    void patchClicked(const bolster::CoverPoint& point);
    /// By the right button or the menu key; what lies there is selected then.
    void contextMenuWanted(const QPoint& global, bool onSomething);
    /// Instead, while a tool has begun something.
    void toolMenuWanted(const QPoint& global, const bolster::ToolKeys& keys);
    /// What a tool could not do, in the user's words.
    void failed(const QString& message);

protected:
    bool event(QEvent* event) override;
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
    Document& document() override { return m_document; }
    Selection& selection() override { return m_selection; }
    const PatternScene& scene() const override { return m_scene; }
    const SnapSettings& snapSettings() const override { return m_snap; }
    SurfaceMeshPtr surface() const override { return m_surface; }
    void endTool() override;
    bool handle(QEvent* event);
    void toolFailed(const std::exception& error);
    bool pointsShown(ElementId id) const override;
    void refresh() override;
    void report(const QString& problem) override;

    void designChanged(const std::set<ElementId>& ids);
    void apply(const PatternTransform& transform);
    void showBox(const Box2& box);
    void fit();
    void placeLegend();
    std::vector<QRectF> busyPlaces() const;
    QString toolTipAt(QPointF pixel) const;
    std::optional<CoverPoint> patchPointAt(QPointF pixel) const;
    void placeCrosshair();
    PatternPointer pointerOf(const QMouseEvent& event) const;
    bool rightButtonSelects() const;

    Document& m_document;
    Selection& m_selection;
    ProblemSet& m_problems;
    PatternScene m_scene;
    PatternMesh m_mesh;
    PatternMap m_map;
    SurfaceMapPtr m_mapShown;
    MapLegend* m_legend;
    bool m_legendShown = true;
    Crosshair* m_crosshair;
    std::optional<CoverPoint> m_place; ///< of the cross-hair
    QPointF m_pressedAt;               ///< the left button
    bool m_moving = false;             ///< the pointer: what lies under it is looked up once
    mutable std::optional<std::pair<QPointF, PatternHit>> m_hit; ///< while m_moving
    SurfaceMeshPtr m_surface;
    std::map<ElementId, QColor> m_seamColors;
    PatternTransform m_transform;
    PatternLayers m_layers;
    std::set<ElementId> m_mirrored; ///< of what is selected or under the pointer
    std::set<ElementId> m_hidden;   ///< in the 3D view
    SnapSettings m_snap;
    PatternGuides m_guides;
    bool m_guidesShown = true;
    bool m_lasso = false;
    BackgroundPicture m_background;
    std::vector<PatternRuler*> m_rulers;
    PatternToolKind m_toolKind = PatternToolKind::Select;
    std::unique_ptr<PatternTool> m_tool;
    QString m_prompt;
    Box2 m_fitted; ///< in the layout: fills the view, whatever its size, until the user moves it
    bool m_spaceDown = false;
    std::optional<QPointF> m_panFrom;
};

} // namespace bolster
