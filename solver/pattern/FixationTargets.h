// Where fixed vertices belong: the last part of OutlineSampling.
#pragma once

#include "OutlineCuts.h"
#include "OutlineSampling.h"

namespace bolster {

/// Curve parameters and targets of all chains, samples being known; reports two targets for one vertex. The cuts
/// need only know the spans.
void aimFixations(OutlineSampling& sampling, const OutlineCuts& cuts, const Design& design);

} // namespace bolster
