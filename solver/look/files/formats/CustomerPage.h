// A page for the customer: one file with a viewer and the model in it, which asks no server for anything.
#pragma once

#include "CoverModel.h"

namespace bolster {

/// What pages are made of; whoever has files gives it.
struct PageParts {
    std::string html;                   ///< with {{title}} and the like where the rest belongs
    std::string style;                  ///< CSS
    std::string script;                 ///< the page's own
    std::vector<std::string> libraries; ///< scripts of others, in their order
    std::string licence;                ///< of those
};

/// What the page says of a seam.
struct PageSeam {
    std::string name;
    double length = 0;                 ///< on the cover, mm
    std::vector<Eigen::Vector3f> line; ///< mm, z up, a little above the cover
};

struct PageFacts {
    std::string title;
    std::vector<PageSeam> seams;
    std::vector<std::string> colors; ///< "#rrggbb" for the button of each colourway
    /// Width, depth and height as seen from the front, mm.
    Eigen::Vector3f size = Eigen::Vector3f::Zero();
};

std::string customerPage(const PageParts& parts, const CoverModel& model, const PageFacts& facts);

/// RFC 4648.
std::string base64(std::string_view bytes);

} // namespace bolster
