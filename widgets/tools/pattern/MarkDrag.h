// Drags what a cutter needs: notches and corners along their outline, drill holes, allowances of edges.
#pragma once

#include "PatternDrags.h"

namespace bolster {

/// Where in its patch a hole lies: "120, 40", mm, as its properties say it.
std::optional<Vec2> typedPosition(const QString& text);

/// A width that allowances may have, mm.
std::optional<double> typedAllowance(const QString& text);
/// What the text means for a mark: the width of an allowance, how far a notch is from the nearer corner, the
/// position of a hole. Nothing when it means none.
std::optional<Edit> typedMark(const Design& design, ElementId mark, const QString& text);

/// Null for elements that are no such mark. Widths of allowances are round (0.5 mm) unless Ctrl or Alt is held.
std::unique_ptr<PatternDrag> dragMark(PatternToolContext& context, const PatternPointer& from, ElementId mark);

} // namespace bolster
