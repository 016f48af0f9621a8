// Walks through the pattern by keys.
#pragma once

#include "Design.h"

namespace bolster {

class Selection;

/// Selects the patch after (or before) the selected ones, the first (or last) when there is none; if control points
/// of one curve are selected, its next (or previous) point. By increasing id, and round again. False when there is
/// nothing to select.
bool selectNext(const Design& design, Selection& selection, bool forward);

} // namespace bolster
