// Another join of the cut lines at a corner of an outline.
#pragma once

#include "CutAllowance.h"
#include "OutlinePlace.h"

namespace bolster {

struct CutCorner {
    OutlinePlace place;
    CornerJoin join = CornerJoin::Mitred;

    friend bool operator==(const CutCorner&, const CutCorner&) = default;
};

} // namespace bolster
