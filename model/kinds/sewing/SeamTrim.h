// What one sees of a seam: stitches, piping, and how the cover lies beside it. Never changes the shape.
#pragma once

#include "ElementId.h"

#include <string>

namespace bolster {

struct SeamTrim {
    enum class Stitch {
        None,
        Single, ///< one row: of a seam on its first side, else inside the outline, or along the curve
        Twin    ///< a row on both sides; along an outline both inside, the second twice as far from it
    };

    Stitch stitch = Stitch::None;
    std::string thread = "#e6dccb"; ///< colour, "#rrggbb", lower case
    double stitchLength = 5;        ///< mm, 0.5 to 100
    double stitchDistance = 4;      ///< from the seam, mm, 0 to 100
    double threadWidth = 0.8;       ///< mm, 0.05 to 10
    double pipingRadius = 0;        ///< mm, 0 to 50; 0: no piping
    ElementId pipingFabric{};       ///< none: the fabric of the patch
    double allowance = 8; ///< width of the bulge that a plain seam's allowance makes, mm, 0 to 100; 0: none
    bool valley = true;   ///< the cover dips into a plain seam

    bool hasPiping() const { return pipingRadius > 0; }
    /// Whether there is more to see than a plain seam.
    bool hasTrimmings() const { return stitch != Stitch::None || hasPiping(); }

    friend bool operator==(const SeamTrim&, const SeamTrim&) = default;
};

} // namespace bolster
