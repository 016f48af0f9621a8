// One run of the program, with what it printed.
#pragma once

#include <QProcess>
#include <QString>

#include <string>

namespace bolster {

struct ProgramRun {
    int exitCode = -1; ///< -1: crashed, or did not end in time
    std::string out;
    std::string err;
};

/// Where there is no display.
QProcessEnvironment bareEnvironment();

ProgramRun runProgram(const QStringList& arguments, const QProcessEnvironment& environment = bareEnvironment());

/// The same within this process, for tests of many short runs: loading the program takes longer than they do.
ProgramRun callCommandLine(const QStringList& arguments);

} // namespace bolster
