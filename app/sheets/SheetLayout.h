// Pieces on a table that will be divided into sheets.
#pragma once

#include "CutTable.h"
#include "SheetGrid.h"

#include <stop_token>

namespace bolster {

/// On as few sheets as are found, a piece that fits on one on one, turned by 90 degrees if only so; on rolls side
/// by side. Incomplete when it is stopped.
CutTable arrangedOnSheets(const CutPattern& pattern, const PaperSize& paper, bool landscape,
                          const std::stop_token& stop);

} // namespace bolster
