// What is to be baked: the look of every place of a tile.
#pragma once

#include "Fabric.h"
#include "ImagePixels.h"
#include "LinearLight.h"
#include "PeriodicNoise.h"

#include <functional>

namespace bolster {

/// One place of a tile.
struct Texel {
    float height = 0; ///< mm
    Light color = Light::Constant(0.2f);
    float roughness = 0.7f; ///< 0 to 1
};

/// A tile before it is baked. Width and height in mm are whole numbers of what repeats.
struct FabricPattern {
    int width = 16; ///< pixels
    int height = 16;
    double widthMm = 10;
    double heightMm = 10;
    double sheen = 0;
    /// The place: 0 to 1 from left to right and from the bottom up. Called from several threads.
    std::function<Texel(const Spot&)> texel = [](const Spot&) { return Texel{}; };
};

FabricPattern plainPattern(const Fabric& fabric);
FabricPattern checkerPattern(const Fabric& fabric, int pixels);
FabricPattern wovenPattern(const Fabric& fabric, int pixels);
FabricPattern velvetPattern(const Fabric& fabric, int pixels);
FabricPattern smoothLeatherPattern(const Fabric& fabric, int pixels);
FabricPattern grainedLeatherPattern(const Fabric& fabric, int pixels);
/// `threads` as in BakeOptions. For a null image: the sign for a missing one.
FabricPattern imagePattern(const Fabric& fabric, const ImagePixels* image, int pixels, int threads);

/// The scale of the look, or the usual one where that is nonsense, mm.
double scaleOf(const Fabric& fabric);
/// A square tile of so many repeats that it is about `size` mm wide, yet not so many that they drown in pixels.
int repeatsFor(const Fabric& fabric, double size, int least, int most);

} // namespace bolster
