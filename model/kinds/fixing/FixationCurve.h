// A curve on the upholstery frame to which the cover is fixed: C_j of the paper, section 3.1.
#pragma once

#include "BSpline.h"
#include "Twin.h"

#include <optional>
#include <string>

namespace bolster {

struct FixationCurve {
    std::string name;
    BSpline3 curve;                ///< open or closed, mm
    std::optional<Twin> twin = {}; ///< mirrored at the plane of the design
    std::string note = {};         ///< for people

    friend bool operator==(const FixationCurve&, const FixationCurve&) = default;
};

} // namespace bolster
