// The program's samples, for benchmarks.
#pragma once

#include "SolveInput.h"

#include <string>

namespace bolster::bench {

/// A design among the installed samples ("armchair/armchair"), or among those of the sources, with its files. Edges
/// in mm, 0: as they are in it. Throws when it cannot be read.
SolveInput sampleScene(const std::string& name, double edge);

} // namespace bolster::bench
