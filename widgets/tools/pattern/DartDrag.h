// Handles of a selected dart: its tip, and its mouth, which is moved along the outline.
#pragma once

#include "PatternDrags.h"

namespace bolster {

/// The seam of the dart that is selected, alone or by the control point at its tip; else none.
ElementId selectedDart(const Design& design, const Selection& selection);

enum class DartHandle { Tip, Mouth };

/// Of the selected dart, under the pixel.
std::optional<DartHandle> dartHandleAt(PatternToolContext& context, QPointF pixel);
/// `over`: the one under the pointer, if any.
void paintDartHandles(QPainter& painter, const ViewColors& colors, PatternToolContext& context,
                      std::optional<DartHandle> over);

/// The tip snaps to where both legs are of one length, Shift keeps it there, Ctrl and Alt let go. Where the dart
/// cannot be, it stays where it could. Typed: how deep it is; of the mouth how far its middle is from the nearer
/// corner. Null without a selected dart.
std::unique_ptr<PatternDrag> dragDart(PatternToolContext& context, const PatternPointer& from, DartHandle handle);

} // namespace bolster
