// What a fabric looks like. Mechanics know nothing of it.
#pragma once

#include <string>

namespace bolster {

struct FabricLook {
    enum class Kind { Plain, Checker, SmoothLeather, GrainedLeather, Woven, Velvet, Image };

    Kind kind = Kind::Plain;
    std::string
        secondColor; ///< the checker's other squares, the weft, the creases of leather: "#rrggbb", lower case;
                     ///< "": derived from the fabric's colour
    double roughness = 0.7; ///< 0: polished, 1: matt
    double scale = 10;      ///< real size of what repeats, mm, > 0: see usualLook
    double rotation = 0;    ///< against the grain line, degrees, counter-clockwise
    double relief = 1;      ///< strength of the normal map, 0: flat, to 2
    std::string file = {};  ///< of an image; relative to the design's folder, never outside it

    friend bool operator==(const FabricLook&, const FabricLook&) = default;
};

/// The defaults of a kind. Its scale is the edge of a checker's square, the grain of leather (from crease to
/// crease), the repeat of a weave, the nap of velvet, or the width of an image.
FabricLook usualLook(FabricLook::Kind kind);

} // namespace bolster
