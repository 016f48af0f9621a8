// Scans that pull at a cover, which the pattern alone does not make.
#pragma once

#include "Design.h"

namespace bolster {

/// No scan pulls at the cover of this one: it is the cover that the pattern alone makes, which goals are about.
Design withoutPulls(const Design& design);
bool hasPulls(const Design& design);
/// They differ at most in what pulls.
bool hasSameCover(const Design& a, const Design& b);

} // namespace bolster
