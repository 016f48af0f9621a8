// What `bolster render` is to do.
#pragma once

#include "Arguments.h"
#include "CoverMap.h"
#include "PictureFile.h"
#include "PictureStudio.h"

namespace bolster::cli {

struct RenderOrder {
    QString design;
    QString image;
    PictureFormat format = PictureFormat::Png;
    PictureOrder picture; ///< all but the colourway
    std::string viewName;
    std::string colourway; ///< "": the design's own
    int turntable = 0;     ///< pictures; 0: none

    /// Throws UsageError.
    static RenderOrder from(std::span<const std::string> words);
};

} // namespace bolster::cli
