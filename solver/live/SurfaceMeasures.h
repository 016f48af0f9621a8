// What a report says of a surface: gaps, errors, strain, areas.
#pragma once

#include "PreparedSheet.h"
#include "SheetState.h"
#include "SolveReport.h"

namespace bolster {

class Relaxation;

/// Everything but iterations, movement and times.
SolveReport measureSurface(const PreparedSheet& sheet, const SheetState& state);
/// Everything; the total time is the sum of the stages.
SolveReport reportOn(const PreparedSheet& sheet, const Relaxation& relaxation);

} // namespace bolster
