// A curve drawn in a patch and fixed to a curve in space: H_k and H'_k of the paper, section 3.5; or held in how
// the cover leans there, or both.
#pragma once

#include "Orientation.h"
#include "PatchCurve.h"
#include "Stretch.h"

#include <string>

namespace bolster {

struct HandleCurve : PatchCurve {
    BSpline3 target; ///< where the curve lies, mm, closed when it is; empty: only the orientation is held
    Match match = Match::Length;
    Orientation orientation = {}; ///< from the curve's start to its end
    std::string note = {};        ///< for people

    bool hasTarget() const { return !target.empty(); }

    friend bool operator==(const HandleCurve&, const HandleCurve&) = default;
};

} // namespace bolster
