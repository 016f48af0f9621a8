// A fabric's look as maps. All of it follows from the fabric's few numbers and, for a picture, from its pixels.
#pragma once

#include "Fabric.h"
#include "FabricMaps.h"
#include "ImagePixels.h"

namespace bolster {

/// What the maps are to be.
struct BakeOptions {
    int pixels = 1024; ///< of the longer side of the tile, 16 to 4096; what is simple (Plain) gets fewer
    int threads = 0;   ///< 0: as many as there are cores. The maps are the same with any number
};

/// The maps of a fabric: a pure function, the same bytes on every run. About 0.1 to 0.5 s at 1024 pixels, so not
/// for the GUI thread. The scale of the look is met in mm; its rotation is left to those who draw. Nonsense in the
/// fabric (a scale of 0, a colour that is none) makes a usable tile all the same. `image`: what the look's file
/// shows; null where there is none or it was refused: then a tile that is clearly a sign, squares in magenta and
/// grey.
FabricMapsPtr bakeFabric(const Fabric& fabric, const ImagePixels* image = nullptr, const BakeOptions& options = {});

/// True when the maps of both are the same, given the same picture: names and mechanics do not matter.
bool looksAlike(const Fabric& a, const Fabric& b);

/// The mean of the albedo as "#rrggbb": what the fabric looks like from far away.
std::string meanColor(const FabricMaps& maps);

} // namespace bolster
