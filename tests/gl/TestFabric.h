// A woven fabric made of formulas, to see what the 3D view does with maps.
#pragma once

#include "FabricMaps.h"

namespace bolster::test {

/// A plain weave of 4 mm, dark red warp over light weft; `pixels` a side.
FabricMapsPtr wovenFabric(int pixels = 128);

} // namespace bolster::test
