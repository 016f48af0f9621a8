// What a change of the design asks of the solver.
#pragma once

#include "SolveInput.h"

namespace bolster {

enum class SolvePlan {
    Nothing,   ///< names, colours, layout, frames that nothing comes from: the surface stays
    Republish, ///< depth and profile of fancy seams: the solution stays, what is shown of it changes
    Retarget,  ///< right-hand sides only: what is held has moved, pressure, Poisson parameter, cushions, scans
    Refactor,  ///< matrix values too: stiffness, bending length, continuity
    Warp,      ///< points of outlines and of curves in them have moved: the triangulation is bent while they do
    Rebuild,   ///< outlines, curves in them, edge length: triangulate again, positions and frames are carried over
    Resew      ///< Rebuild, and seams or fixations came or went, so that the surface is torn
};

/// What two changes ask for together.
SolvePlan together(SolvePlan a, SolvePlan b);

/// Cheap: shared elements are not looked into, of others only the fields that matter are compared.
SolvePlan planSolve(const SolveInput& before, const SolveInput& after);

} // namespace bolster
