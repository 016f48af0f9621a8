// How large a patch is, as it lies in the layout.
#pragma once

#include "Patch.h"

namespace bolster {

/// Which axis of the outline's coordinates lies nearer to the layout's horizontal: 0 or 1.
int widthAxis(const Patch& patch);
/// Width and height, mm: of a patch that lies turned by a multiple of 90 degrees those of its box in the layout, of
/// others along the axes of its outline.
Vec2 patchSize(const Patch& patch);

} // namespace bolster
