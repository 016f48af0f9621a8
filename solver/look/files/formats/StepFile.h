// Curves for CAD: STEP, application protocol 214.
#pragma once

#include "BSpline.h"

#include <string>
#include <vector>

namespace bolster {

struct StepCurve {
    std::string name;
    BSpline3 curve; ///< mm
};

/// Curves that belong together.
struct StepCurves {
    std::string name;
    std::vector<StepCurve> curves;
};

/// ISO 10303-21 text with a geometric curve set for each of these that has curves; millimetres, the design's axes.
/// The same curves give the same text.
std::string stepFile(const std::string& product, const std::vector<StepCurves>& sets);

} // namespace bolster
