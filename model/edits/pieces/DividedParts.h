// What a cut through a patch has divided, when the pieces are merged again. Private to the library.
#pragma once

#include "EditBuilder.h"

#include <span>

namespace bolster::edits {

/// Parts that meet where two patches were merged become one if one of them alone would mean the same: seams,
/// fixations, trims and allowances that follow each other and match the same points, handle curves of which one
/// ends where the other begins, fancy seams that both patches had. The one with the smaller id stays.
/// `before` tells which of the two patches each drawn curve lay in; `joints` are the parameters of the merged
/// outline at which the halves meet.
void joinDivided(const Design& before, ElementId merged, ElementId gone, std::span<const double> joints,
                 EditBuilder& builder);

} // namespace bolster::edits
