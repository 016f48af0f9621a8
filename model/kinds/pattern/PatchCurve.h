// A curve drawn inside a patch: what handle curves and fancy seams have in common (paper, section 3.5).
#pragma once

#include "BSpline.h"
#include "ElementId.h"
#include "Twin.h"

#include <optional>
#include <string>

namespace bolster {

/// What becomes of a drawn curve when its piece is cut.
enum class LineUse { Drawn, Cut, Ignored };

struct PatchCurve {
    std::string name;
    ElementId patch{};
    BSpline2 curve; ///< open or closed, outline coordinates, mm
    LineUse use = LineUse::Drawn;
    std::optional<Twin> twin = {}; ///< mirrored at x = 0 of the outlines, targets at the plane of the design

    friend bool operator==(const PatchCurve&, const PatchCurve&) = default;
};

} // namespace bolster
