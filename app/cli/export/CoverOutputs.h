// The files of the cover that `bolster export` writes.
#pragma once

#include "CoverFiles.h"
#include "Interrupt.h"
#include "OutputFiles.h"
#include "Solving.h"

#include <functional>
#include <vector>

namespace bolster::cli {

/// What it takes on the command line.
extern const std::vector<OptionRule> coverRules;

class CoverOutputs {
public:
    /// Throws UsageError.
    explicit CoverOutputs(const Arguments& arguments);

    bool empty() const { return m_wanted.empty(); }
    void protectInputs(const QString& designPath, const Design& design) const;
    bool canBeWritten() const { return m_files.canBeWritten(); }
    /// Solves, and writes all that is wanted, with a line about each. `writeOthers` comes first, when everything
    /// has been made, and returns whether it was done. Returns the exit code.
    int write(const QString& designPath, const OpenedDesign& opened, bool lenient, Interrupt& interrupt,
              const std::function<bool()>& writeOthers) const;

private:
    struct Wanted {
        const char* option;
        CoverFormat format;
    };

    std::vector<Wanted> m_wanted;
    OutputFiles m_files;
    CoverFileOptions m_options;
};

} // namespace bolster::cli
