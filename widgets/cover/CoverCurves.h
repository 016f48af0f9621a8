// The design's curves in space, fixation curves and targets of handles, as polylines, kept until the curves change.
#pragma once

#include "Design.h"

#include <map>
#include <set>
#include <vector>

namespace bolster {

struct CoverCurve {
    ElementPtr element;
    std::vector<Vec3> points;       ///< along the curve, mm; a closed one ends where it starts
    std::vector<double> parameters; ///< of the points

    bool handle() const { return std::holds_alternative<HandleCurve>(*element); }
    const BSpline3& spline() const { return *spaceCurve(*element); }
};

class CoverCurves {
public:
    /// Without those that are `unseen`.
    void update(const Design& design, const std::set<ElementId>& unseen = {});
    const std::map<ElementId, CoverCurve>& all() const { return m_curves; }
    Box3 box() const; ///< mm
    Box3 box(const std::set<ElementId>& ids) const;

private:
    std::map<ElementId, CoverCurve> m_curves;
};

} // namespace bolster
