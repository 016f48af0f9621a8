// How far along the outline a place is from a corner: shown while something is placed there, and typed.
#pragma once

#include "PatternTool.h"

#include <optional>

namespace bolster {

/// The place on the outline that is as far as the text says (a length) from the corner nearest to `t`, on the same
/// side of it; nothing when the text is no length, or the next corner is nearer.
std::optional<double> typedAlongOutline(const BSpline2& outline, double t, const QString& text);

/// The way along the outline from the corner nearest to the place, with its length. `patch` may be another version
/// of the shown one.
void paintWayFromCorner(QPainter& painter, const ViewColors& colors, const PatternToolContext& context,
                        ElementId id, const Patch& patch, double at);

} // namespace bolster
