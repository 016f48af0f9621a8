// What a pattern that is made anew takes the place of.
#pragma once

#include "Design.h"

#include <vector>

namespace bolster::edits {

/// Patches of the names that pieces of `made` have (numbers behind them aside, of which there may be others now,
/// and
/// "_" as good as a space), and the fixation curves of such names that hold nothing else.
std::vector<ElementId> earlierPieces(const Design& design, const Design& made);
/// With the names that patches and curves have there: groups of files have "_" where names have spaces.
Design withEarlierNames(const Design& design, const Design& made);
/// With patches that are about as large as those of their names were in the middle of where these were, once all
/// are moved by `offset` (mm, in the layout).
Design withEarlierPlaces(const Design& design, const Design& made, const Vec2& offset);

} // namespace bolster::edits
