// What an edit would break, for gestures: until its end such an edit is shown as invalid and taken back on release.
#pragma once

#include "Design.h"

#include <set>

namespace bolster::edits {

struct Breakage {
    Message why;                  ///< a sentence about the first thing that breaks
    std::set<ElementId> elements; ///< what is shown as invalid: all that break
};

/// Outlines that would cross themselves or enclose nothing, curves that would leave their patches, stretches that
/// would lose their length or overlap other seams, fixations or trims. Only what the edit changes is looked at,
/// with the seams and curves of changed outlines; and what was broken before the edit may stay so, or nobody could
/// mend it step by step. Fast enough for every step of a drag.
std::optional<Breakage> brokenBy(const Design& before, const Edit& edit);

} // namespace bolster::edits
