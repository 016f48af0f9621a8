// Editing rules for measurements. Pure: Design in, Edit out.
#pragma once

#include "Design.h"

namespace bolster::edits {

/// Between two points of patches; a name that is taken gets a number. Empty where a patch is missing, or both
/// points are the same.
Edit addMeasurement(const Design& design, const PatchPoint& from, const PatchPoint& to, const std::string& name);

} // namespace bolster::edits
