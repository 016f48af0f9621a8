// What a change of the design asks of the solver.
#pragma once

#include "Field.h"
#include "SolveInput.h"

namespace bolster {

/// The descriptions of the kinds say what each field costs.
using SolvePlan = SolveCost;

/// What two changes ask for together.
SolvePlan together(SolvePlan a, SolvePlan b);

/// Cheap: shared elements are not looked into, of others only the fields that matter are compared.
SolvePlan planSolve(const SolveInput& before, const SolveInput& after);

} // namespace bolster
