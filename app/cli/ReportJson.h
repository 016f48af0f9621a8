// The file of `bolster solve --report`.
#pragma once

#include "RestingSolve.h"

#include <string>

namespace bolster::cli {

/// Keys and units: docs/command-line.md.
std::string reportJson(const SolveResult& result);

} // namespace bolster::cli
