// Bolster without a window: `bolster solve`, `bolster check` ... (docs/command-line.md).
#pragma once

#include <optional>

namespace bolster {

/// Runs what the arguments ask for and returns the exit code: 0 done, 1 other failures, 2 bad input or usage,
/// 3 not converged. Nothing when they ask for the window. Needs no application object, and prints English and
/// numbers with "." whatever the locale, for scripts.
std::optional<int> runCommandLine(int argc, char** argv);

} // namespace bolster
