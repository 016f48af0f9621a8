// How far beyond the sewing line fabric is cut.
#pragma once

namespace bolster {

/// How the cut lines of two edges are joined outside a corner of the outline.
enum class CornerJoin {
    Mitred,  ///< both run on until they meet; very sharp ones are cut off
    Square,  ///< cut off across the corner, at the allowance's distance from it
    Rounded, ///< an arc around the corner
    Folded,  ///< the first edge's allowance, folded back along it, lies under the piece and no wider
    Stepped  ///< the first edge's allowance ends at right angles to it, where the other cut line crosses it
};

struct CutAllowance {
    double width = 10; ///< mm, >= 0
    CornerJoin corner = CornerJoin::Mitred;

    friend bool operator==(const CutAllowance&, const CutAllowance&) = default;
};

} // namespace bolster
