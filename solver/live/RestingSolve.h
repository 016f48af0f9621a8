// The resting surface: a function of the design alone.
#pragma once

#include "SolveInput.h"
#include "SolveReport.h"
#include "SurfaceMesh.h"

#include <functional>
#include <stop_token>

namespace bolster {

struct SolveOptions {
    double tolerance = 1e-6; ///< estimated distance to the limit, relative to D, at which the solve ends
    int maxIterations = 5000;
    int threads = 0;       ///< 0: as many as the machine has; the result does not depend on it
    bool oneLevel = false; ///< on the design's triangles alone and with momentum alone, to compare with
    bool lenient = false;  ///< leave bad elements out instead of failing
};

struct SolveResult {
    enum class Status { Solved, NotConverged, Failed, Cancelled };

    Status status = Status::Failed;
    Message reason;  ///< when not solved
    Problems errors; ///< what is wrong with the input
    Problems warnings;
    Problems leftOut;       ///< lenient only
    SurfaceMeshPtr surface; ///< null when failed
    SolveReport report;
};

/// Solves from the canonical start. Bit for bit the same on any run and number of threads.
/// `progress(iteration, movement)` is called on the caller's thread after each iteration.
SolveResult solveResting(const SolveInput& input, const SolveOptions& options, std::stop_token stop = {},
                         const std::function<void(int, double)>& progress = {});

/// Everything that is wrong with a design as far as the solver can tell without solving: checkDesign, and what
/// only shows when stretches are matched (one vertex with two different fixation targets ...) and patches become
/// triangles (too narrow for their edges). Nothing when stopped.
Problems checkSolvable(const Design& design, const std::stop_token& stop = {});
/// Of a pattern that was made: which of its patches are so narrow that no cover can be solved with its mesh edges.
/// Empty when there is none, or when stopped.
Message tooNarrowForEdges(const Design& design, const std::stop_token& stop = {});

} // namespace bolster
