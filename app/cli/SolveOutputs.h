// The files that `bolster solve` writes.
#pragma once

#include "OutputFiles.h"
#include "RestingSolve.h"

#include <stop_token>

namespace bolster::cli {

class SolveOutputs {
public:
    /// Throws UsageError when two outputs are the same file.
    SolveOutputs(const Arguments& arguments, int threads);

    const OutputFiles& files() const { return m_files; }

    /// Writes what was asked for, prints a line for each, and tries everything even if something fails. Without a
    /// surface only the report is written. False when something could not be written.
    bool write(const SolveResult& result, const Design& design, std::stop_token stop) const;

private:
    OutputFiles m_files;
    int m_threads;
};

} // namespace bolster::cli
