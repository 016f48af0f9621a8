// What a pattern that is made anew takes the place of.
#pragma once

#include "Design.h"

#include <optional>
#include <vector>

namespace bolster::edits {

/// Patches of the names that pieces of `made` have (numbers behind them aside, of which there may be others now,
/// and
/// "_" as good as a space), and the fixation curves of such names that hold nothing else.
std::vector<ElementId> earlierPieces(const Design& design, const Design& made);
/// With the names that patches and curves have there: groups of files have "_" where names have spaces.
Design withEarlierNames(const Design& design, const Design& made);
/// With each patch in the middle of where that of its name was in the layout; nothing where one was not there, or
/// was not about as large, so that they would lie on each other.
std::optional<Design> withEarlierPlaces(const Design& design, const Design& made);

} // namespace bolster::edits
