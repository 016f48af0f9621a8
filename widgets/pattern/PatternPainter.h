// Draws a PatternScene.
#pragma once

#include "PatternMap.h"
#include "PatternMesh.h"
#include "PatternScene.h"
#include "PatternTransform.h"
#include "ViewColors.h"

#include <QFont>
#include <QPolygonF>
#include <QSize>

class QPainter;

namespace bolster {

class ProblemSet;
struct CutPattern;
class Selection;

/// What the pattern view shows; a window offers these as toggles.
struct PatternLayers {
    bool grid = true;
    bool mesh = false;
    bool seams = true;
    bool points = true;
    bool labels = true;
    bool handles = true; ///< handle curves
    bool fancySeams = true;
    bool cutting = false; ///< cut lines, notches, labels, holes
    bool measurements = true;

    bool shows(const PatternLine& line) const
    {
        return line.fancy() ? fancySeams : std::holds_alternative<InternalLine>(*line.element) || handles;
    }
    bool twins = true;    ///< the mirror image of what is selected
    bool symmetry = true; ///< the axis

    friend bool operator==(const PatternLayers&, const PatternLayers&) = default;
};

/// Where a side of a seam has its arrow and letter, pixels.
struct SeamBadge {
    QRectF box;
    ElementId seam{};
    ElementId patch{};
    double middle = 0; ///< of the stretch: parameter of the outline
};

/// One picture; made anew for each paint event.
class PatternPainter {
public:
    struct Input {
        const PatternScene& scene;
        const PatternMesh& mesh;
        const PatternMap& map;
        const Selection& selection;
        const ProblemSet& problems;
        const std::set<ElementId>& invalid; ///< what the present drag would break
        const std::map<ElementId, QColor>& seamColors;
        PatternTransform transform;
        PatternLayers layers;
        ViewColors colors;
        QFont font;
        QSize size;
        const std::set<ElementId>& mirrored; ///< of what is selected or under the pointer
        const std::set<ElementId>& hidden;   ///< in the 3D view: drawn faintly here
        const CutPattern* cut = nullptr;     ///< the production pattern, if it is shown
    };

    PatternPainter(QPainter& painter, const Input& input);
    void paint();
    /// Those that were painted, the uppermost last.
    const std::vector<SeamBadge>& badges() const { return m_badges; }

    /// Control points are shown where they are far enough apart to be grabbed.
    static bool pointsReadable(const PatternPatch& patch, const PatternTransform& transform);

private:
    bool selected(ElementId id) const;
    bool hovered(ElementId id) const;
    bool bad(ElementId id) const;
    bool mirrored(ElementId id) const;
    bool hidden(ElementId id) const;
    bool visible(const PatternPatch& patch) const;
    bool tiny(const PatternPatch& patch) const;
    using Stretches = std::vector<const std::pair<const ElementId, PatternStretch>*>;
    const Stretches& stretchesOf(const PatternPatch& patch) const;
    using Trims = std::vector<const std::pair<const ElementId, PatternTrim>*>;
    QPainterPath inPixels(const QPainterPath& path) const;

    void paintPatch(const PatternPatch& patch);
    void paintSpeck(const PatternPatch& patch);
    void paintHiddenPatch(const PatternPatch& patch);
    void paintMap(const PatternPatch& patch, const QPainterPath& outline);
    void paintMesh(const PatternPatch& patch);
    void paintSeamBands(const PatternPatch& patch, const QPainterPath& outline);
    void paintTrims(const PatternPatch& patch);
    void paintFixations(const PatternPatch& patch);
    void paintInside(const PatternPatch& patch);
    void paintSeamArrows(const PatternPatch& patch, const QRectF& written);
    void paintSeamLinks();
    void paintLine(const PatternLine& line);
    void paintMeasures();
    void paintAllPoints();
    void paintFollowers();
    void paintPoints(ElementId id, const std::vector<Vec2>& points, const std::vector<char>& corners,
                     const BSpline2& curve);

    QPainter& m_painter;
    const Input& m_in;
    QTransform m_matrix;
    Box2 m_visible;
    std::map<ElementId, Stretches> m_stretches; ///< by patch
    std::map<ElementId, Trims> m_trims;         ///< by patch
    std::vector<SeamBadge> m_badges;
    std::vector<QPolygonF> m_words; ///< written inside of patches that have cut lines, pixels
};

} // namespace bolster
