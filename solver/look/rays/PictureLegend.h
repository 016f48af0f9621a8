// What the colours of a map mean, in the picture itself.
#pragma once

#include "MapScale.h"
#include "PreviewRenderer.h"

#include <string>

namespace bolster {

/// All texts UTF-8, in the user's language and with units.
struct PictureLegend {
    MapScale scale;
    std::string title;
    std::string lowest; ///< at the bar's left end
    std::string middle; ///< of a scale with two sides; else unused
    std::string highest;
    std::string over; ///< what nearly black means; "": there are no limits
};

/// In the lower left corner, sized by the picture. Pictures too small for a legend to be read stay as they are.
/// `problem` says when there is no font; the bar is there nevertheless.
void drawLegend(PreviewImage& image, const PictureLegend& legend, std::string& problem);

} // namespace bolster
