// A hole that is drilled through the stack of cut fabric: a mark for pockets, buttons, ties.
#pragma once

#include "PatchPoint.h"

#include <string>

namespace bolster {

struct DrillHole {
    std::string name;
    PatchPoint place;
    double diameter = 3;   ///< mm, > 0
    std::string note = {}; ///< for people

    friend bool operator==(const DrillHole&, const DrillHole&) = default;
};

} // namespace bolster
