// Where the square that is measured after printing lies on a sheet.
#pragma once

#include "SheetPlan.h"

#include <QPointF>

namespace bolster {

/// Its side, mm.
inline constexpr double testSquare = 100;

struct SquarePlace {
    QPointF corner;    ///< the upper left one, mm from that of the paper
    bool free = false; ///< no piece lies there
};

/// Where nothing lies; if there is no such place inside a piece, but on none of its lines; at last where it meets
/// the fewest lines.
SquarePlace squarePlace(const CutPattern& pattern, const SheetPlan& plan, const Sheet& sheet,
                        const CutLayers& layers);

} // namespace bolster
