// Everything on the cover that is drawn as a line or a dot: seams, borders, curves in space, what is selected.
#pragma once

#include "CoverCurves.h"
#include "FieldPicture.h"
#include "ViewScene.h"

namespace bolster {

class Selection;

/// The colour of fixation curves; selected ones take the accent.
QColor fixationCurveColor(const ViewColors& colors);

/// Of the mirror image of what is selected.
QColor mirroredColor(const ViewColors& colors);

/// Adds sections and arrows, seen through the cover.
void addFieldLines(const FieldPicture& field, ViewScene& scene);

/// Takes away the lines and dots that the scene's section cuts off.
void cutMarks(ViewScene& scene);

/// Fills in the scene's lines and dots: all curves, and what lies on the cover.
class SceneMarks {
public:
    struct Shown {
        bool seams = true;
        bool heldNormals = true;
        std::set<ElementId> mirrored = {}; ///< of what is selected or under the pointer
    };

    SceneMarks(const Design& design, const CoverCurves& curves, const Selection& selection, Shown shown)
        : m_design(design)
        , m_curves(curves)
        , m_selection(selection)
        , m_shown(shown)
    {}

    void fill(ViewScene& scene, std::optional<std::pair<ElementId, int>> hoveredPoint) const;

private:
    bool mirrored(ElementId id) const { return m_shown.mirrored.contains(id); }
    void addSeams(ViewScene& scene) const;
    void addFancySeams(ViewScene& scene) const;
    void addOutlines(ViewScene& scene) const;
    void addCurve(ViewScene& scene, ElementId id, const CoverCurve& curve) const;
    void addHeldNormals(ViewScene& scene) const;
    void addControlPoints(ViewScene& scene, ElementId id, const CoverCurve& curve, int hovered) const;

    const Design& m_design;
    const CoverCurves& m_curves;
    const Selection& m_selection;
    Shown m_shown;
};

} // namespace bolster
