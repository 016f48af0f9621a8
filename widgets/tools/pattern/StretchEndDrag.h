// Handles at the ends of selected seams and fixations, and dragging them along the outline.
#pragma once

#include "PatternDrags.h"
#include "SeamEdits.h"

#include <optional>
#include <vector>

namespace bolster {

/// A handle of a selected seam or fixation seam; it lies on the stretch, a little inside the end, so that two ends
/// in one place can be told apart.
struct StretchEndHandle {
    ElementId owner{};
    edits::SeamSide side = edits::SeamSide::A;
    edits::StretchEnd end = edits::StretchEnd::From;
    QPointF pixel;
};

std::vector<StretchEndHandle> stretchEndHandles(PatternToolContext& context);
std::optional<StretchEndHandle> stretchEndAt(PatternToolContext& context, QPointF pixel);
/// `over`: the one under the pointer, if any.
void paintStretchEnds(QPainter& painter, const ViewColors& colors, PatternToolContext& context,
                      const std::optional<StretchEndHandle>& over);

/// Moves the end along the outline, never past the other end. Snaps to corners, to ends of other stretches and to
/// where both sides of the seam are of one length, unless Ctrl or Alt is held.
std::unique_ptr<PatternDrag> dragStretchEnd(PatternToolContext& context, const PatternPointer& from,
                                            const StretchEndHandle& handle);

} // namespace bolster
