// Patterns as SVG: 1:1, for vector programs, laser cutters and browsers.
#pragma once

#include "CutLayers.h"
#include "CutPattern.h"

namespace bolster {

/// Millimetres; a group for each layer (cut, sew, notches, grain, labels, internal, holes), no CSS.
std::string svgText(const CutPattern& pattern, const CutLayers& layers);

} // namespace bolster
