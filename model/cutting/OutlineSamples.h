// An outline as a polygon that is fine enough to cut.
#pragma once

#include "BSpline.h"

#include <vector>

namespace bolster {

struct OutlineSample {
    Vec2 at = Vec2::Zero(); ///< mm
    double parameter = 0;   ///< of the curve
    bool corner = false;    ///< the tangent jumps here
};

/// How fine: the curve is nowhere farther than `chord` (mm) from the polygon, nor is its offset by `reach` (mm)
/// from the polygon's.
struct SampleOrder {
    double chord = 0.05;
    double reach = 0;
    std::vector<double> breaks = {}; ///< parameters that get a sample in any case
};

/// In increasing parameter; of a closed curve the first one is not repeated, of an open one both ends are corners.
std::vector<OutlineSample> sampled(const BSpline2& curve, const SampleOrder& order);

} // namespace bolster
