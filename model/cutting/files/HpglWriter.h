// Patterns for plotters.
#pragma once

#include "CutLayers.h"
#include "CutPattern.h"

namespace bolster {

/// HPGL in steps of 0.025 mm, at most `width` mm wide; what is inside of a piece comes before its cut line.
std::string hpglText(const CutPattern& pattern, const CutLayers& layers, double width);

} // namespace bolster
