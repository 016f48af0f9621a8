// The files that a subcommand is told to write.
#pragma once

#include "Arguments.h"
#include "Design.h"

#include <functional>
#include <initializer_list>

namespace bolster::cli {

/// Why a file cannot be written, as far as that is known before ("is a folder"); "" when it may well be.
std::string whyNotWritten(const QString& path);

/// False when one of these files cannot be written, as far as that is known before: prints why; "" is none.
bool canBeWritten(std::initializer_list<QString> paths);
/// Likewise of a folder that is made when it is not there.
bool canBeMade(const QString& folder);

class OutputFiles {
public:
    /// Throws UsageError when two of these options name the same file. Results go to stderr as long as one of them
    /// is what stdout leads to: nothing shall come in between.
    OutputFiles(const Arguments& arguments, std::initializer_list<const char*> options);
    ~OutputFiles();
    OutputFiles(const OutputFiles&) = delete;
    OutputFiles& operator=(const OutputFiles&) = delete;

    bool empty() const { return m_paths.empty(); }
    bool has(const std::string& option) const { return m_paths.contains(option); }

    /// Throws UsageError when an output would overwrite the design or one of its files: "chair.json --obj
    /// chair.obj" beside a frame chair.obj is typed soon.
    void protectInputs(const QString& designPath, const Design& design) const;

    /// False when one of them cannot be written, as far as that is known before: prints why. What is written then
    /// is all of them, or none.
    bool canBeWritten() const;

    /// Calls the writer with the option's file if there is one, and prints a line about what came of it. False when
    /// it could not be written.
    bool write(const std::string& option, const std::function<Message(const QString&)>& writer) const;

private:
    std::map<std::string, QString> m_paths; // by option
    bool m_standardOutput = false;          // one of them is what stdout leads to
};

} // namespace bolster::cli
