// A dart while it is made or dragged: where its points catch, the wedge, how long its legs are.
#pragma once

#include "DartEdits.h"
#include "PatternTool.h"

#include <QString>

namespace bolster {

/// Whether the legs are equally long, as far as anybody could sew.
bool hasEqualLegs(const Patch& patch, const edits::DartShape& dart);
/// The place on the outline next to the pointer; in a corner or in the middle of an edge where that is near, unless
/// Ctrl or Alt is held.
std::optional<double> placeOnOutline(const PatternToolContext& context, ElementId patch,
                                     const PatternPointer& pointer);
/// The tip on the axis of the mouth if it is near to it (pixels), or always; with whole millimetres of depth.
Vec2 snappedTip(const PatternToolContext& context, const Patch& patch, const edits::DartShape& dart,
                bool always = false);
/// "Mouth 20 mm"
QString mouthText(const Patch& patch, const edits::DartShape& dart);

/// With its measures. `good`: it can be cut so. `mouth`: with how wide that is.
void paintDart(QPainter& painter, const ViewColors& colors, const PatternToolContext& context, const Patch& patch,
               const edits::DartShape& dart, bool good, bool mouth = true);

} // namespace bolster
