// A distance that the designer keeps an eye on, between two points of the cover.
#pragma once

#include "PatchPoint.h"

#include <string>

namespace bolster {

/// Straight, in the pattern where both points are of one patch, and on the cover.
struct Measurement {
    std::string name;
    PatchPoint from;
    PatchPoint to;
    std::string note = {}; ///< for people

    friend bool operator==(const Measurement&, const Measurement&) = default;
};

} // namespace bolster
