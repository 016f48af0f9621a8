// Forms that covers are compared with, as commands name them.
#pragma once

#include "Arguments.h"
#include "DesignFile.h"
#include "FileGuess.h"
#include "FitGoals.h"

namespace bolster::cli {

/// Of a file's numbers: what `--unit` and `--up` say, else what the file says, else mm, and z points up.
Placement placementOf(const Arguments& arguments, const QString& file, FileFacts said);

/// Of a mesh, or points, in a file, as placementOf has it. Throws UsageError when it holds neither.
FitTarget targetIn(const QString& path, const Arguments& arguments, const std::stop_token& stop);

/// Throws UsageError when the design has no scan, or several; `option` is what names a file instead.
FitTarget scanOf(const OpenedDesign& opened, const std::string& option);

/// That a scan pulls at the cover which `solve` finds, which is left out here.
void sayOfPulls(const Design& design);

} // namespace bolster::cli
