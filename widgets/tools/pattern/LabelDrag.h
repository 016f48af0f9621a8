// Drags the label of a piece to where it can be read best.
#pragma once

#include "PatternDrags.h"

namespace bolster {

/// The patch whose piece has its label under the pixel, or its name where the label cannot be read, while cut lines
/// are shown; else none.
ElementId labelAt(const PatternToolContext& context, QPointF pixel);
void paintLabelFrame(QPainter& painter, const ViewColors& colors, const PatternToolContext& context,
                     ElementId patch);

/// Its middle snaps to the middle of the piece's box, level and upright; Ctrl and Alt let go. Null without a label.
std::unique_ptr<PatternDrag> dragLabel(PatternToolContext& context, const PatternPointer& from, ElementId patch);

} // namespace bolster
