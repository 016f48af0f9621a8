// A notch that somebody placed.
#pragma once

#include "NotchShape.h"
#include "OutlinePlace.h"

#include <string>

namespace bolster {

/// On a seam, the other side has one where it meets this one.
struct Notch {
    OutlinePlace place;
    NotchShape shape = {};
    bool twice = false;    ///< two side by side, to tell front from back
    std::string note = {}; ///< for people

    friend bool operator==(const Notch&, const Notch&) = default;
};

} // namespace bolster
