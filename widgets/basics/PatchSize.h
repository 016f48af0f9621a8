// How large a patch is, as it lies in the layout.
#pragma once

#include "Patch.h"

namespace bolster {

/// Width and height of its box, mm.
Vec2 patchSize(const Patch& patch);

} // namespace bolster
