// The subcommands. They print, and return the exit code.
#pragma once

#include "Arguments.h"

namespace bolster::cli {

enum ExitCode { done = 0, otherFailure = 1, badInput = 2, notConverged = 3 };

/// `words` is what follows the name of the subcommand. They throw UsageError.
int check(std::span<const std::string> words);
int solve(std::span<const std::string> words);
int bench(std::span<const std::string> words);

extern const char* const checkHelp;
extern const char* const solveHelp;
extern const char* const benchHelp;

} // namespace bolster::cli
