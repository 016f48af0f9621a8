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

/// Principal stretches (larger first) of a triangle's map from `rest` (mm) to `place` (mm).
Eigen::Vector2d principalStretches(const std::array<Vec2, 3>& rest, const std::array<Vec3, 3>& place);

} // namespace bolster
