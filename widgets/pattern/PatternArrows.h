// Where a pattern would go: arrows over it.
#pragma once

#include "Design.h"
#include "PatternTransform.h"

#include <optional>
#include <vector>

class QPainter;

namespace bolster {

struct ViewColors;

struct PatternArrow {
    Vec2 from, to; ///< layout, mm
};

struct PatternArrows {
    std::vector<PatternArrow> arrows;
    double longer = 1; ///< how many times as long as the way they stand for
};

/// Along all outlines that differ, about every `apart` mm; so much longer than the way that they can be seen, but
/// no longer than `longest` mm; with `longer` as said, so that arrows of parts of a change can be compared.
PatternArrows arrowsBetween(const Design& before, const Design& after, double apart, double longest,
                            std::optional<double> longer = {});

void paintArrows(QPainter& painter, const PatternArrows& arrows, const PatternTransform& transform,
                 const ViewColors& colors);

} // namespace bolster
