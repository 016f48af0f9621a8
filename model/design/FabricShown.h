// Which fabric a patch shows: the colourway decides what is seen, Patch::fabric how the cover behaves.
#pragma once

#include "Design.h"

namespace bolster {

/// Under the design's own colourway, or a given one (noElement: none). Settings and colourways that refer to
/// nothing leave the patch its own fabric; noElement when there is no such patch.
ElementId fabricShown(const Design& design, ElementId patch);
ElementId fabricShown(const Design& design, ElementId patch, ElementId colourway);

/// How a fabric's maps lie on a patch: the direction of their x in outline coordinates, radians, counter-clockwise.
/// Their y runs along the patch's grain, turned by what the fabric asks for.
double clothTurn(const Patch& patch, const Fabric& fabric);

} // namespace bolster
