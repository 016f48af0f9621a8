// The curves of a cover that CAD asks for.
#pragma once

#include "MakeCoverModel.h"
#include "StepFile.h"

namespace bolster {

/// Fixation curves as the design has them; seams where they lie on the cover, within `tolerance` (mm) of the
/// solver's points.
std::vector<StepCurves> curvesForCad(const ModelSubject& subject, double tolerance = 0.05);

} // namespace bolster
