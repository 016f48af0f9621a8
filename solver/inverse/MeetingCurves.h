// Fixation curves that meet in a point still do when they have moved.
#pragma once

#include "Design.h"

namespace bolster {

/// `after` with the ends of fixation curves that met in `before` (within 0.01 mm, as the solver asks) put together
/// again: half-way where ends met, on the other curve where one ended on it.
Design withMeetingCurves(const Design& before, const Design& after);

} // namespace bolster
