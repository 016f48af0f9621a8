// What the pattern view shows: the patches in their layout, kept up to date with design, selection and what is
// handed in.
#pragma once

#include "CoverPlaces.h"
#include "CutPattern.h"
#include "LatestJob.h"
#include "PatternPainter.h"
#include "SurfaceMesh.h"

#include <QObject>

#include <map>
#include <optional>
#include <set>

namespace bolster {

class Document;
class ProblemSet;
class Selection;

class ShownPattern : public QObject {
    Q_OBJECT

public:
    /// All must outlive it.
    ShownPattern(const Document& document, const Selection& selection, const ProblemSet& problems,
                 const ViewColors& colors);

    /// Where the triangulation comes from; null for none.
    void setSurface(const bolster::SurfaceMeshPtr& surface);
    const SurfaceMeshPtr& surface() const { return m_surface; }
    /// Colours on the patches; null for none.
    void setMap(const ShownMapPtr& map);
    /// What fabrics look like from far away, by their ids.
    void setFabricColors(std::map<bolster::ElementId, QColor> colors);
    /// Elements that the 3D view does not show.
    void setHidden(std::set<bolster::ElementId> hidden);
    const PatternLayers& layers() const { return m_layers; }
    void setLayers(const PatternLayers& layers);
    void setColors(const ViewColors& colors);

    const PatternScene& scene() const { return m_scene; }
    /// The production pattern while its layer is shown, a little behind the design; or null.
    const std::shared_ptr<const CutPattern>& cut() const { return m_cut; }
    /// What lies under the pixel.
    PatternHit hit(const PatternTransform& transform, QPointF pixel) const;
    /// The seam whose arrow and letter were painted there last, as a hit on its stretch; or nothing.
    PatternHit hitBadge(QPointF pixel) const;
    const std::vector<SeamBadge>& badges() const { return m_badges; }
    /// The point of a patch under the pixel, where `found` lies.
    std::optional<CoverPoint> pointOf(const PatternHit& found, const PatternTransform& transform,
                                      QPointF pixel) const;
    /// Where that is in the layout, mm; nothing without the patch.
    std::optional<Vec2> placeOf(const CoverPoint& point) const;
    bool pointsShown(ElementId id, const PatternTransform& transform) const;
    /// Name, measures and problems of what was hit.
    QString toolTip(const PatternHit& found) const;

    void paint(QPainter& painter, const PatternTransform& transform, const QFont& font, QSize size) const;

signals:
    /// To be painted anew.
    void changed();
    void layersChanged();

private:
    void designChanged(const std::set<bolster::ElementId>& ids);
    void selectionChanged();
    void requestCut();

    const Document& m_document;
    const Selection& m_selection;
    const ProblemSet& m_problems;
    ViewColors m_colors;
    PatternScene m_scene;
    PatternMesh m_mesh;
    PatternMap m_map;
    SurfaceMeshPtr m_surface;
    std::map<ElementId, QColor> m_seamColors;
    PatternLayers m_layers;
    mutable std::vector<SeamBadge> m_badges; ///< as they were painted last
    std::set<ElementId> m_mirrored;          ///< of what is selected or under the pointer
    std::set<ElementId> m_hidden;            ///< in the 3D view
    std::shared_ptr<const CutPattern> m_cut;
    LatestJob<Design, std::shared_ptr<const CutPattern>> m_cutJob; ///< last: it uses the others
};

} // namespace bolster
