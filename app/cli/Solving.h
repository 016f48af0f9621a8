// From an opened design to its cover, for the commands that need one.
#pragma once

#include "DesignFile.h"
#include "RestingSolve.h"

namespace bolster::cli {

/// openDesignOrProject() with a word on the terminal.
OpenedDesign openedShown(const QString& path);

/// Adds the error of a design that has nothing wrong and nothing to solve, which every command sees as one.
void addMissingPatch(Problems& problems, const Design& design);

/// What was left out and why: the errors themselves, then what went because it refers to a bad element.
Problems allLeftOut(const Problems& errors, const Problems& others);

/// Refuses designs with errors, unless `options` are lenient. What went wrong is in the result.
SolveResult solveOpened(const OpenedDesign& opened, const SolveOptions& options, std::stop_token stop);

/// Of a solve that is given up in the middle.
SolveResult interruptedResult();

/// On stderr, for commands that take no design with errors. Whether there were any.
bool printErrors(const Problems& problems);

/// On stderr: errors, what was left out, warnings, and why there is no cover.
void printFindings(const SolveResult& result);

} // namespace bolster::cli
