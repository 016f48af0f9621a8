// Seams between sheets that were parted, drawn anew. Private to the library.
#pragma once

#include "SheetTrials.h"

#include <vector>

namespace bolster {

/// Seams that go to and fro, along edges of coarse triangles where the form is round, become shorter ones, where
/// that strains the pieces hardly more.
void straighten(std::vector<FormSheet>& sheets, const SheetTrials& trials);

} // namespace bolster
