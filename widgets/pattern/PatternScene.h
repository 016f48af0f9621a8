// The pattern as the views draw and hit it: outlines, stretches and labels in layout millimetres, kept until the
// elements they come from change.
#pragma once

#include "Design.h"
#include "LabelPlace.h"
#include "PatternMeasures.h"
#include "PatternTrims.h"
#include "PatternTwins.h"

#include <QColor>
#include <QPainterPath>

#include <functional>
#include <map>
#include <optional>
#include <set>

namespace bolster {

/// The part of an outline between two corners.
struct PatternEdge {
    double from = 0;            ///< parameters of the outline
    double to = 0;              ///< unwrapped: larger than `from`
    double length = 0;          ///< along the curve, mm
    Vec2 middle = Vec2::Zero(); ///< half way along the curve, outline coordinates
    bool ends = true;           ///< false: the whole of an outline without corners
};

struct PatternPatch {
    ElementId id{};
    ElementPtr element;
    QColor fabric;
    QPainterPath path;         ///< closed
    Box2 box;                  ///< of the path
    std::vector<Vec2> points;  ///< control points
    std::vector<char> corners; ///< per control point: the outline has a corner there
    std::vector<PatternEdge> edges;
    /// Searched for when somebody asks: of many thousand patches few have room for a name on the screen.
    const LabelPlace& label() const;
    mutable std::optional<LabelPlace> knownLabel;

    const Patch& patch() const { return std::get<Patch>(*element); }
};

/// One side of a seam, or a stretch that is fixed.
struct PatternStretch {
    ElementId owner{}; ///< Seam, FixationSeam or OutlineTrim
    ElementId patch{};
    double from = 0;
    double to = 0;               ///< unwrapped: larger than `from`
    bool fixation = false;       ///< of a fixation seam
    ElementId curve = noElement; ///< of a fixation seam that has one
    bool backwards = false;      ///< the seam walks it from `to` to `from`
    QPainterPath path;           ///< in the direction in which the seam walks it

    bool contains(const BSpline2& outline, double parameter) const;
};

/// A handle curve or fancy seam.
struct PatternLine {
    ElementId id{};
    ElementId patch{};
    ElementPtr element;
    QPainterPath path;
    std::vector<Vec2> points;  ///< control points
    std::vector<char> corners; ///< per control point

    const BSpline2& curve() const { return *planeCurve(*element); }
    const FancySeam* fancy() const { return std::get_if<FancySeam>(element.get()); }
};

/// A notch, a corner of the cut line, a drill hole, or the allowance of an edge: what is picked as a point.
struct PatternMark {
    ElementId id{};
    ElementId patch{};
    Vec2 place = Vec2::Zero(); ///< in the layout
};

/// What lies at a place of the layout.
struct PatternHit {
    enum class Kind { Nothing, Inside, Outline, Line, Point, Mark, Measure };

    Kind kind = Kind::Nothing;
    ElementId patch{};          ///< Kind::Point: the element whose point it is
    int point = -1;             ///< Kind::Point
    double parameter = 0;       ///< Kind::Outline, Kind::Line
    ElementId seam = noElement; ///< Kind::Outline: the seam or fixation seam that runs there; Kind::Line and
                                ///< Kind::Mark: the line, the mark; the measurement

    explicit operator bool() const { return kind != Kind::Nothing; }
    /// The element that a click selects.
    ElementId element() const { return seam == noElement ? patch : seam; }
};

class PatternScene {
public:
    /// Brings everything up to date of which the design differs in `changed`.
    void update(const Design& design, const std::set<ElementId>& changed);
    void reset(const Design& design);
    /// What fabrics look like from far away; those that are not listed have their own colour.
    void setFabricColors(const Design& design, std::map<ElementId, QColor> colors);

    const std::map<ElementId, PatternPatch>& patches() const { return m_patches; }
    const PatternPatch* patch(ElementId id) const;
    /// By owner; a seam has two.
    const std::multimap<ElementId, PatternStretch>& stretches() const { return m_stretches; }

    const std::map<ElementId, PatternLine>& lines() const { return m_lines; }
    const std::map<ElementId, PatternMark>& marks() const { return m_marks; }
    const PatternMeasures& measures() const { return m_measures; }
    const PatternTwins& twins() const { return m_twins; }
    const PatternTrims& trims() const { return m_trims; }

    Box2 boundingBox() const;
    /// Of patches, of lines in them, and of the patches at seams; empty when none of the ids lies in the layout.
    Box2 boundingBox(const std::set<ElementId>& ids) const;

    /// Points before marks and measurements before lines before outlines before inside; upper patches before lower
    /// ones. `tolerance` in mm. Points are hit only where `pointsShown`.
    /// Lines are hit only where `lineShown`, marks if `marksShown`, measurements if `measuresShown`.
    PatternHit hit(const Vec2& at, double tolerance, const std::function<bool(ElementId)>& pointsShown,
                   const std::function<bool(const PatternLine&)>& lineShown = {}, bool marksShown = false,
                   bool measuresShown = false) const;

private:
    QColor colorShown(const Design& design, ElementId patch) const;
    void updatePatch(const Design& design, ElementId id);
    void updateLine(const Design& design, ElementId id);
    void updateMark(const Design& design, ElementId id);
    void updateStretches(const Design& design, ElementId owner);
    void addStretch(PatternStretch added, const Stretch& stretch);
    std::optional<PatternHit> hitPoint(const Vec2& at, double tolerance,
                                       const std::function<bool(ElementId)>& pointsShown) const;
    std::optional<PatternHit> hitMark(const Vec2& at, double tolerance) const;
    std::optional<PatternHit> hitLine(const Vec2& at, double tolerance,
                                      const std::function<bool(const PatternLine&)>& lineShown) const;
    std::optional<PatternHit> hitOutline(const Vec2& at, double tolerance) const;

    std::map<ElementId, PatternPatch> m_patches; ///< later ones lie on top
    std::multimap<ElementId, PatternStretch> m_stretches;
    std::map<ElementId, PatternLine> m_lines;
    std::map<ElementId, PatternMark> m_marks;
    PatternMeasures m_measures;
    PatternTwins m_twins;
    std::map<ElementId, QColor> m_fabricColors;
    PatternTrims m_trims;
};

} // namespace bolster
