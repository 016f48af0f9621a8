// Keeps a distance in the design.
#pragma once

#include "PatchPoint.h"

namespace bolster {

class ViewToolContext;

/// As a measurement with a name of its own, and selects it.
void keepMeasure(ViewToolContext& context, const PatchPoint& from, const PatchPoint& to);

} // namespace bolster
