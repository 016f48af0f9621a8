// Cushioning between the frame and the cover: a field of forces that pushes the cover outwards.
#pragma once

#include "ElementId.h"

#include <string>
#include <vector>

namespace bolster {

struct Cushion {
    enum class Distance { CityBlock, Euclidean };

    std::string name;
    ElementId frame{};
    std::vector<std::string> parts; ///< of the frame's file; none: those that belong to the cover, guessed
    std::vector<ElementId> patches; ///< it pushes what they are sewn to; none: everything
    double voxel = 5;               ///< mm
    double dilation = 30;           ///< mm of padding around the frame
    double strength = 1;            ///< scales the force
    Distance distance = Distance::CityBlock;
    bool enabled = true;
    std::string note = {}; ///< for people

    friend bool operator==(const Cushion&, const Cushion&) = default;
};

} // namespace bolster
