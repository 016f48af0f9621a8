// What a fabric is like on the cutting table.
#pragma once

namespace bolster {

struct FabricCutting {
    double width = 1400;     ///< that can be used, mm
    double shrinkAlong = 0;  ///< of what is cut until it is worn, along the grain, %
    double shrinkAcross = 0; ///< across the grain, %

    friend bool operator==(const FabricCutting&, const FabricCutting&) = default;
};

} // namespace bolster
