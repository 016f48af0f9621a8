// A hole that is drilled through the stack of cut fabric: a mark for pockets, buttons, ties.
#pragma once

#include "ElementId.h"
#include "Geometry.h"

#include <string>

namespace bolster {

struct PatchPoint {
    ElementId patch{};
    Vec2 position = Vec2::Zero(); ///< outline coordinates, mm

    friend bool operator==(const PatchPoint&, const PatchPoint&) = default;
};

struct DrillHole {
    std::string name;
    PatchPoint place;
    double diameter = 3;   ///< mm, > 0
    std::string note = {}; ///< for people

    friend bool operator==(const DrillHole&, const DrillHole&) = default;
};

} // namespace bolster
