// Everything on the cover that is drawn as a line or a dot: seams, borders, curves in space, what is selected.
#pragma once

#include "FieldPicture.h"
#include "SurfaceCurves.h"
#include "SurfaceScene.h"

namespace bolster {

class Selection;

/// The colour of fixation curves; selected ones take the accent.
QColor fixationCurveColor(const ViewColors& colors);

/// Of the mirror image of what is selected.
QColor mirroredColor(const ViewColors& colors);

/// Adds sections and arrows, seen through the cover.
void addFieldLines(const FieldPicture& field, SurfaceScene& scene);

/// Takes away the lines and dots that the scene's section cuts off.
void cutMarks(SurfaceScene& scene);

/// Fills in the scene's lines and dots: all curves, and what lies on the cover.
class SurfaceMarks {
public:
    struct Shown {
        bool seams = true;
        bool heldNormals = true;
        std::set<ElementId> mirrored = {}; ///< of what is selected or under the pointer
    };

    SurfaceMarks(const Design& design, const SurfaceCurves& curves, const Selection& selection, Shown shown)
        : m_design(design)
        , m_curves(curves)
        , m_selection(selection)
        , m_shown(shown)
    {}

    void fill(SurfaceScene& scene, std::optional<std::pair<ElementId, int>> hoveredPoint) const;

private:
    bool mirrored(ElementId id) const { return m_shown.mirrored.contains(id); }
    void addSeams(SurfaceScene& scene) const;
    void addFancySeams(SurfaceScene& scene) const;
    void addOutlines(SurfaceScene& scene) const;
    void addCurve(SurfaceScene& scene, ElementId id, const SurfaceCurve& curve) const;
    void addHeldNormals(SurfaceScene& scene) const;
    void addControlPoints(SurfaceScene& scene, ElementId id, const SurfaceCurve& curve, int hovered) const;

    const Design& m_design;
    const SurfaceCurves& m_curves;
    const Selection& m_selection;
    Shown m_shown;
};

} // namespace bolster
