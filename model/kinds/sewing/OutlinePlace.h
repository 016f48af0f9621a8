// A place on a patch's outline.
#pragma once

#include "ElementId.h"

namespace bolster {

struct OutlinePlace {
    ElementId patch{};
    double at = 0; ///< parameter of the outline

    friend bool operator==(const OutlinePlace&, const OutlinePlace&) = default;
};

} // namespace bolster
