// Bakes what bakeFabric() promises.
#pragma once

#include "BakeFabric.h"

namespace bolster {

FabricMapsPtr paintedFabric(const Fabric& fabric, const ImagePixels* image, const BakeOptions& options);

} // namespace bolster
