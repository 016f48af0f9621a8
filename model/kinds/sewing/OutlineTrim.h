// Stitches and piping along a stretch of an outline that is not sewn.
#pragma once

#include "SeamTrim.h"
#include "Stretch.h"

#include <string>

namespace bolster {

struct OutlineTrim {
    Stretch stretch;
    SeamTrim trim = {};
    std::string note = {}; ///< for people

    friend bool operator==(const OutlineTrim&, const OutlineTrim&) = default;
};

} // namespace bolster
