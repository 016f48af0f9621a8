// The rules for single elements of a design. Private to the library.
#pragma once

#include "ArcLength.h"
#include "Design.h"

#include <map>

namespace bolster {

/// Length of the longer one over that of the shorter one, minus 1; 0 when there is none.
double ease(double lengthA, double lengthB);
/// Whether two stretches of one outline have more than end points in common.
bool stretchesOverlap(const BSpline2& outline, const Stretch& first, const Stretch& second);
/// Whether two patches meet right side to right side when the second one's outline is walked backwards.
bool rightSidesMeetReversed(const Patch& a, const Patch& b);

class ElementRules {
public:
    /// Reports into `problems`.
    ElementRules(const Design& design, Problems& problems);

    void check(ElementId id, const Element& element);

private:
    friend class FieldRules;

    // What the descriptions do not say.
    void rules(const Settings& settings);
    void rules(const Fabric& fabric);
    void rules(const Patch& patch);
    void rules(const Seam& seam);
    void rules(const FixationSeam& seam);
    void rules(const Frame& frame);
    void rules(const HandleCurve& handle);
    void rules(const Foam& foam);
    void rules(const Scan& scan);
    void rules(const Colourway& colourway);
    void rules(const OutlineTrim& trimmed);
    void rules(const EdgeAllowance& allowance);
    void rules(const CutCorner& corner);
    void rules(const Notch& notch);
    void rules(const DrillHole& hole);
    void rules(const Measurement& measurement);
    void rules(const Quarantined& quarantined);

    void twin(const Element& element);

    void error(std::string field, Message message);
    void warn(std::string field, Message message);
    /// Reports a number outside [low, high], NaN too; says whether it is inside.
    bool inRange(std::string field, double value, double low, double high);
    void scale(const Placement& placement);
    template <class T>
    const T* reference(std::string field, ElementId id);
    /// The patch, if the stretch and its outline are sound; `prefix` is "a." or "b." or nothing.
    const Patch* stretch(const std::string& prefix, const Stretch& stretch);
    /// Reports a curve without length.
    template <int Dim>
    void needsLength(std::string field, const BSpline<Dim>& curve);
    void color(std::string field, const std::string& text);
    /// Reports a parameter that the outline does not have.
    void place(const OutlinePlace& place);
    template <int Dim>
    bool range(const std::string& fromField, const std::string& toField, const BSpline<Dim>& curve, double from,
               double to);
    void directions(const Orientation& orientation);
    bool sewsAnew(const Seam& seam);
    double lengthOf(const Stretch& stretch, const BSpline2& outline);
    const std::optional<Message>& outlineProblemOf(ElementId id, const BSpline2& outline);

    const Design& m_design;
    Problems& m_problems;
    ElementId m_id{};
    std::string m_label;
    double m_smallestEdge; // that the patches allow, mm
    std::set<ElementId> m_usedFabrics;
    std::map<ElementId, ElementId> m_twins;                 // originals by follower
    std::map<ElementId, ArcLength2> m_lengths;              // by patch
    std::map<ElementId, std::optional<Message>> m_outlines; // by patch: what is wrong

    using StretchKey = std::tuple<ElementId, double, double>;
    std::map<std::pair<StretchKey, StretchKey>, std::pair<ElementId, bool>> m_sewn; // the seam, whether reversed
};

} // namespace bolster
