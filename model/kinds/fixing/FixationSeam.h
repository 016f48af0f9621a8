// Holds a stretch of an outline: its place by a fixation curve, ((i, r, s), j) of the paper, section 3.1, and how
// the cover leans there.
#pragma once

#include "Orientation.h"
#include "SeamTrim.h"
#include "Stretch.h"

#include <optional>
#include <string>
#include <utility>

namespace bolster {

struct FixationSeam {
    Stretch stretch;
    ElementId curve{};                                   ///< none: only the orientation is held
    std::optional<std::pair<double, double>> curveRange; ///< from, to on the curve; nothing: the whole curve
    bool reversed = false;                               ///< the curve is walked backwards
    Match match = Match::Length;
    Orientation orientation = {}; ///< from the stretch's start to its end
    SeamTrim trim = {};
    std::string note = {}; ///< for people

    bool hasCurve() const { return curve != noElement; }

    friend bool operator==(const FixationSeam&, const FixationSeam&) = default;
};

} // namespace bolster
