// How long stretches of outlines are.
#pragma once

#include "Design.h"

namespace bolster {

/// Arc length, mm; 0 when the stretch does not lie on its outline.
double stretchLength(const Design& design, const Stretch& stretch);

} // namespace bolster
