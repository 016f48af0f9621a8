// A curve drawn in a patch and fixed to a curve in space: H_k and H'_k of the paper, section 3.5.
#pragma once

#include "PatchCurve.h"
#include "Stretch.h"

namespace bolster {

struct HandleCurve : PatchCurve {
    BSpline3 target; ///< where the curve lies on the cover; closed when the curve is, mm
    Match match = Match::Length;

    friend bool operator==(const HandleCurve&, const HandleCurve&) = default;
};

} // namespace bolster
