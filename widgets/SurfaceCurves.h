// The design's fixation curves as polylines, kept until the curves change.
#pragma once

#include "Design.h"

#include <map>
#include <vector>

namespace bolster {

struct SurfaceCurve {
    ElementPtr element;
    std::vector<Vec3> points;       ///< along the curve, mm; a closed one ends where it starts
    std::vector<double> parameters; ///< of the points

    const FixationCurve& fixation() const { return std::get<FixationCurve>(*element); }
    const BSpline3& spline() const { return fixation().curve; }
};

class SurfaceCurves {
public:
    void update(const Design& design);
    const std::map<ElementId, SurfaceCurve>& all() const { return m_curves; }

private:
    std::map<ElementId, SurfaceCurve> m_curves;
};

} // namespace bolster
