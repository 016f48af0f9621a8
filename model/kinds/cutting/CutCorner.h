// Another join of the cut lines at a corner of an outline.
#pragma once

#include "CutAllowance.h"
#include "OutlinePlace.h"

#include <string>

namespace bolster {

struct CutCorner {
    OutlinePlace place;
    CornerJoin join = CornerJoin::Mitred;
    std::string note = {}; ///< for people

    friend bool operator==(const CutCorner&, const CutCorner&) = default;
};

} // namespace bolster
