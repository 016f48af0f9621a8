// What goes wrong in a subcommand, as a line on stderr and an exit code.
#pragma once

#include <functional>
#include <string>

namespace bolster::cli {

/// Runs a subcommand that is called `name` and returns its exit code, or that of what it throws.
int reported(const std::string& name, const std::function<int()>& command);

} // namespace bolster::cli
