// What `bolster render` is to do.
#pragma once

#include "Arguments.h"
#include "CoverMap.h"
#include "JobShare.h"
#include "PictureFile.h"
#include "PictureStudio.h"
#include "Slurm.h"

#include <optional>
#include <vector>

namespace bolster::cli {

struct NamedView {
    std::string name;
    std::variant<PictureDirection, RayCamera> from;
};

/// Every colourway from every view, into a folder of its own.
struct SeriesOrder {
    QString folder;
    std::string format; ///< the end of the files' names, without the dot
    std::vector<NamedView> views;
    JobShare share;
    std::optional<SlurmOrder> slurm;
    std::string options; ///< what the pictures depend on, beside the design
};

struct RenderOrder {
    QString design;
    QString image;
    PictureFormat format = PictureFormat::Png;
    PictureOrder picture; ///< all but the colourway
    std::string viewName;
    std::string colourway; ///< "": the design's own
    int turntable = 0;     ///< pictures; 0: none
    std::optional<SeriesOrder> series;

    /// Throws UsageError.
    static RenderOrder from(std::span<const std::string> words);
};

} // namespace bolster::cli
