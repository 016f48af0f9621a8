// Darts that nobody has sewn yet. Private to the library.
#pragma once

#include "FreeEdges.h"

namespace bolster {

/// Two edges of one piece that meet in a tip inside of it.
struct DartLegs {
    int first = 0;  ///< edges by their places; it ends at the tip, counter-clockwise
    int second = 0; ///< begins there
    double fit = 0; ///< 0 to 1: how exactly one is the mirror image of the other
};

/// Free edges that lead into a narrow wedge and are mirror images of each other: whoever has cut them wants them
/// sewn.
std::vector<DartLegs> dartLegs(const Design& design, const std::vector<OutlineEdge>& edges);

} // namespace bolster
