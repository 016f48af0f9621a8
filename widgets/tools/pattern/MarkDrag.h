// Drags what a cutter needs: notches and corners along their outline, drill holes, allowances of edges.
#pragma once

#include "PatternDrags.h"

namespace bolster {

/// Null for elements that are no such mark. Widths of allowances are round (0.5 mm) unless Ctrl or Alt is held.
std::unique_ptr<PatternDrag> dragMark(PatternToolContext& context, const PatternPointer& from, ElementId mark);

} // namespace bolster
