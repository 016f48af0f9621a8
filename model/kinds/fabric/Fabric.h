// The cover material: how it behaves and what it looks like.
#pragma once

#include "FabricCutting.h"
#include "FabricLook.h"
#include "StretchLimits.h"

#include <string>

namespace bolster {

struct Fabric {
    std::string name;
    double poisson = 0.3;          ///< transverse contraction, within [-0.5, 0.5]
    double stiffness = 1;          ///< relative to the other fabrics, > 0
    double bendingLength = 6;      ///< sets the size of folds, mm, >= 0
    std::string color = "#7a4a2b"; ///< "#rrggbb", lower case
    FabricLook look = {};
    StretchLimits limits = {};
    FabricCutting cutting = {};
    std::string note = {}; ///< for people

    friend bool operator==(const Fabric&, const Fabric&) = default;
};

} // namespace bolster
