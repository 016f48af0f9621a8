// A line inside a piece of the pattern that shapes nothing: a guide for top stitching, a strip to tie down.
#pragma once

#include "PatchCurve.h"

#include <string>

namespace bolster {

struct InternalLine : PatchCurve {
    enum class Purpose { Guide, TopStitch, TieDown, Fold };

    Purpose purpose = Purpose::Guide;
    std::string note = {}; ///< for people

    friend bool operator==(const InternalLine&, const InternalLine&) = default;
};

} // namespace bolster
