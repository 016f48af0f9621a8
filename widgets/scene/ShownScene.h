// What the 3D view shows: its scene, kept up to date with the design, the selection and what is handed in.
#pragma once

#include "CoverCurves.h"
#include "CoverHit.h"
#include "FieldPicture.h"
#include "FramePieceBox.h"
#include "SceneShadows.h"
#include "ShownCover.h"
#include "ShownFrames.h"
#include "ShownScans.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>
#include <map>
#include <optional>
#include <set>

namespace bolster {

class Document;
class Selection;
class SceneVisibility;

class ShownScene : public QObject {
    Q_OBJECT

public:
    /// Who works with the view draws over the scene what is never cut: asked whenever marks are made anew.
    using Overlay = std::function<std::vector<SceneLine>()>;

    /// All must outlive it.
    ShownScene(Document& document, Selection& selection, SceneVisibility& visibility);

    const ViewScene& scene() const { return m_scene; }
    /// There is nothing to see: the scene's box is ground to draw on.
    bool empty() const { return m_empty; }

    /// The cover to show; null for none. Cheap while the topology stays.
    void setSurface(bolster::SurfaceMeshPtr surface);
    const SurfaceMeshPtr& surface() const { return m_cover.surface(); }
    /// The same refined, to be drawn in its place; not taken when another surface is shown meanwhile.
    /// `trims`: stitches and piping on it; may be null.
    void setCover(bolster::CoverMeshPtr cover, bolster::TrimMeshPtr trims = {});
    /// What fabrics look like; those that are not listed are plain.
    void setFabricMaps(std::map<bolster::ElementId, bolster::FabricMapsPtr> maps);
    /// What the design's files hold: frames, foam and scans; their placement is taken from the design.
    void setFiles(const DesignFiles& files);
    /// Colours on the cover; null for none.
    void setMap(VertexMapPtr map);
    /// The forces of cushioning; null for none. Shown in their layer.
    void setField(bolster::FieldPicturePtr field);
    /// Which points of a scan belong to which places of the cover, mm: shown as lines.
    void setScanPairs(std::vector<std::pair<Vec3, Vec3>> pairs);
    /// Whether points of some scan have colours of their own.
    bool hasScanColors() const { return m_scans.points().hasColors(); }
    /// A box around these pieces of a frame (FramePieces), hidden or not; without any: none.
    void showFramePieces(bolster::ElementId frame, const std::vector<int>& pieces);
    /// Of a window beside the view, over everything, never cut; without any: none.
    void setGuests(GuestMarks marks);
    const GuestMarks& guests() const { return m_guests; }
    /// The surface is not up to date, or the last good one before a failure.
    void setDimmed(bool dimmed);
    /// Where it is cut open; nothing: not cut open.
    void setSection(const std::optional<bolster::SectionPlane>& section);
    /// 0 to 1: frames and foam over a cover, usually 0.45; points of scans, usually 1.
    void setFrameOpacity(double opacity);
    void setScanOpacity(double opacity);

    // For the view that draws it.
    void setColors(const ViewColors& colors);
    void setShadows(bool wanted) { m_shadowsWanted = wanted; } ///< the canvas draws them
    void setOverlay(Overlay overlay) { m_overlay = std::move(overlay); }
    void setHoveredPoint(const std::optional<std::pair<ElementId, int>>& point) { m_hoveredPoint = point; }
    /// Makes lines and dots anew: hovered point, overlay or camera have changed.
    void updateMarks();
    /// Likewise, and says so.
    void refreshMarks(bool moving);

    CoverHit hit(const Camera& camera, QPointF pixel) const;
    const CoverHitTest& hits() const { return m_hits; }
    /// The foremost point of the scan near the pixel, mm, where it is shown.
    std::optional<Vec3> scanPoint(ElementId scan, const Camera& camera, QPointF pixel) const;
    /// The same point on the cover (mm), and in the pattern.
    std::optional<Vec3> onCover(const CoverPoint& point) { return m_cover.places().onCover(point); }
    std::optional<Vec3> outwards(const CoverPoint& point) { return m_cover.places().outwards(point); }
    std::optional<CoverPoint> inPattern(const CoverHit& solid) const;
    /// Of what is shown of an element with a placement, mm; its position when nothing is.
    Vec3 middleOf(ElementId id) const;
    Box3 boxWithScans() const; ///< mm: the scene's, and that of the scans that are shown
    Box3 selectedBox() const;  ///< mm; empty: nothing that is shown is selected

signals:
    /// To be drawn anew. `moving`: more of this comes soon.
    void changed(bool moving);
    /// The box around everything; before the marks are made anew.
    void boxChanged();
    void sectionChanged();
    /// Nothing has moved for a while.
    void rested();

private:
    void designChanged(const std::set<bolster::ElementId>& ids);
    void selectionChanged();
    void visibilityChanged();
    void updateMirrored();
    void updateCurves();
    void updateCover();
    void updateFrames();
    void updateScans();
    void updateLooks();
    void updateBox();
    void rest();

    Document& m_document;
    Selection& m_selection;
    SceneVisibility& m_visibility;
    ViewScene m_scene;
    bool m_empty = true;
    FieldPicturePtr m_field;
    DesignFiles m_files;
    FramePieceBox m_pieces;
    Overlay m_overlay;
    GuestMarks m_guests;
    std::optional<std::pair<ElementId, int>> m_hoveredPoint;
    std::set<ElementId> m_mirrored; ///< of what is selected or under the pointer
    CoverCurves m_curves;
    ShownCover m_cover{m_scene};
    ShownScans m_scans{m_scene};
    ShownFrames m_frames;
    CoverHitTest m_hits{m_frames.shapes()};
    SceneShadows m_shadows;
    bool m_shadowsWanted = false;
    QElapsedTimer m_sinceSurface;
    QTimer m_rest;
};

} // namespace bolster
