// Where the name of a patch is written.
#pragma once

#include "Geometry.h"

#include <QPolygonF>
#include <QSizeF>

namespace bolster {

/// The best place inside an outline for a line of text, lying or upright.
struct LabelPlace {
    struct Spot {
        Vec2 centre = Vec2::Zero(); ///< in the polygon's coordinates
        double room = 0;            ///< half the height of the largest line of `aspect` that fits
    };
    static constexpr double aspect = 3; ///< width to height of the line that is looked for

    Spot lying;
    Spot upright;

    /// A line of this size (same unit as the polygon, length along the line first) stays inside the outline there.
    static bool fits(const Spot& spot, const QSizeF& text);
    /// Searches on a grid; good enough for a label, about half a millisecond.
    static LabelPlace inside(const QPolygonF& outline);
};

} // namespace bolster
