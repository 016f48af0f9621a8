// The files that `bolster solve` writes.
#pragma once

#include "Arguments.h"
#include "RestingSolve.h"

#include <stop_token>

namespace bolster::cli {

class SolveOutputs {
public:
    /// Throws UsageError when two outputs are the same file.
    SolveOutputs(const Arguments& arguments, int threads);

    /// Throws UsageError when an output would overwrite the design or one of its frames: "chair.json --obj
    /// chair.obj" beside a frame chair.obj is typed soon.
    void protectInputs(const QString& designPath, const Design& design) const;

    /// Writes what was asked for, prints a line for each, and tries everything even if something fails. Without a
    /// surface only the report is written. False when something could not be written.
    bool write(const SolveResult& result, const Design& design, std::stop_token stop) const;

private:
    std::map<std::string, QString> m_paths; // by option
    int m_threads;
};

} // namespace bolster::cli
