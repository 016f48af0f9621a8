// Stitches and piping along a stretch of an outline that is not sewn.
#pragma once

#include "SeamTrim.h"
#include "Stretch.h"

namespace bolster {

struct OutlineTrim {
    Stretch stretch;
    SeamTrim trim = {};

    friend bool operator==(const OutlineTrim&, const OutlineTrim&) = default;
};

} // namespace bolster
