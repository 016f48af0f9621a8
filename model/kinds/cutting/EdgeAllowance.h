// Another seam allowance along a stretch of an outline.
#pragma once

#include "Stretch.h"

#include <string>

namespace bolster {

struct EdgeAllowance {
    Stretch stretch;
    double width = 10;     ///< mm, >= 0; 0: cut on the sewing line
    std::string note = {}; ///< for people

    friend bool operator==(const EdgeAllowance&, const EdgeAllowance&) = default;
};

} // namespace bolster
