// What is cut into, or out of, the seam allowance to show where edges meet.
#pragma once

namespace bolster {

struct NotchShape {
    enum class Kind { Slit, V, T, Castle, U };

    Kind kind = Kind::Slit;
    double depth = 4; ///< from the cut line towards the sewing line, mm
    double width = 4; ///< along the cut line, mm; a slit has none

    friend bool operator==(const NotchShape&, const NotchShape&) = default;
};

/// Which notches there are without anybody placing them.
struct AutomaticNotches {
    NotchShape shape = {};
    double spacing = 0;  ///< between two along a seam, mm; 0: none between its ends
    bool ends = true;    ///< where a seam stops inside an edge, and where fancy seams meet the outline
    bool telling = true; ///< where the halves of a seam could be swapped: two side by side near its first end

    friend bool operator==(const AutomaticNotches&, const AutomaticNotches&) = default;
};

} // namespace bolster
