// Lines for people and scripts.
#pragma once

#include "Problem.h"

#include <cstdint>
#include <string>

namespace bolster::cli {

/// One line on stdout or stderr. Control characters, which names in a design may hold, are escaped.
void printResult(const std::string& line);
void printError(const std::string& line);
/// Results go to stderr, too: stdout has something else. Until it has been taken back as often as it was asked for.
void sendResultsToErrors(bool send);

/// One line each on stderr: "error: patch 2 "Seat", outline.points: ..."
void printProblems(const Problems& problems);

/// "1 seam", "2 seams"
std::string counted(std::int64_t count, const std::string& thing);

/// "12.3 %" of 0.123. What is less than a thousandth of a percent is rounding, or as good as nothing: "0 %".
std::string percentText(double share, int digits = 3);

/// "1 error, 2 warnings"
std::string countedProblems(const Problems& problems);

} // namespace bolster::cli
