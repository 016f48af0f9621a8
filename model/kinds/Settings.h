// What holds for the whole design.
#pragma once

#include "DesignCutting.h"
#include "ElementId.h"
#include "Symmetry.h"

#include <optional>

namespace bolster {

struct Settings {
    double edgeLength = 12;                ///< mean edge of the triangulation, mm, > 0
    std::optional<Symmetry> symmetry = {}; ///< nothing: the design need not be symmetric; twins use the default
    ElementId colourway{};                 ///< the one that is shown; none: each patch shows its own fabric
    DesignCutting cutting = {};

    friend bool operator==(const Settings&, const Settings&) = default;
};

} // namespace bolster
