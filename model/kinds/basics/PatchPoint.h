// A place inside a patch.
#pragma once

#include "ElementId.h"
#include "Geometry.h"

namespace bolster {

struct PatchPoint {
    ElementId patch{};
    Vec2 position = Vec2::Zero(); ///< outline coordinates, mm

    friend bool operator==(const PatchPoint&, const PatchPoint&) = default;
};

} // namespace bolster
