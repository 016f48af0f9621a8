// A seam between a stretch of an outline and a fixation curve: ((i, r, s), j) of the paper, section 3.1.
#pragma once

#include "Stretch.h"

#include <optional>
#include <utility>

namespace bolster {

struct FixationSeam {
    Stretch stretch;
    ElementId curve{};
    std::optional<std::pair<double, double>> curveRange; ///< from, to on the curve; nothing: the whole curve
    bool reversed = false;                               ///< the curve is walked backwards
    Match match = Match::Length;

    friend bool operator==(const FixationSeam&, const FixationSeam&) = default;
};

} // namespace bolster
