// What `bolster render` is to do.
#pragma once

#include "Arguments.h"
#include "CoverMap.h"
#include "PictureFile.h"
#include "PictureView.h"

namespace bolster::cli {

struct RenderOrder {
    QString design;
    QString image;
    PictureFormat format = PictureFormat::Png;
    PreviewOptions options; ///< size of one picture
    PictureDirection direction;
    std::string viewName;
    std::string colourway; ///< "": the design's own
    bool checker = false;
    std::optional<CoverMap::Kind> map;
    bool sheet = false;
    int turntable = 0; ///< pictures; 0: none

    /// Throws UsageError.
    static RenderOrder from(std::span<const std::string> words);
};

/// Most pixels that a file may have.
constexpr std::int64_t mostPixels = 64'000'000;

} // namespace bolster::cli
