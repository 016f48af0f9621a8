// What the lines of a layer are for. Private to the library.
#pragma once

#include "Drawing.h"

namespace bolster {

enum class LayerRole {
    Unknown,
    Cut,
    Sew,
    Turn,  ///< points at corners
    Curve, ///< points of curves
    Notch,
    Grain,
    Internal,
    InternalCut,
    Hole,
    Text,
    Ignored, ///< grade and plaid references, mirror lines: counted
    FineCut, ///< finer copies of a line, made to compare with: better than the line itself
    FineSew,
    FineInternal,
    FineInternalCut
};

/// Of a number (AAMA, ASTM), or of a word in a few languages: "cut", "Nahtlinie", "stitch line".
LayerRole layerRole(const std::string& layer);

} // namespace bolster
