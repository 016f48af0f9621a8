#include "BenchOptions.h"
#include "HelperProcess.h"
#include "Output.h"
#include "Subcommands.h"

#include <QFile>

#include <unistd.h>

namespace bolster::cli {

const char* const benchHelp = R"(Usage: bolster bench [options]

Measures Bolster's solver against other libraries (CGAL, CHOLMOD, Eigen) on the
same meshes, and prints a table: times in milliseconds, ratio = peer / ours.
Takes up to five minutes; the machine should have nothing else to do.

Options:
  --quick               one minute, without the largest meshes
  --json FILE           the table as JSON: a list of rows
  --markdown FILE       the table as Markdown, with the machine

Exit code:
  0  done
  1  a benchmark failed, an output cannot be written, or interrupted
  2  wrong usage
)";

/// The peers and their libraries are in a program of their own, which nobody has to load who designs. This one
/// becomes it, so that signals, pipes and exit code are its own.
int bench(std::span<const std::string> words)
{
    Arguments(words, benchOptions).expectNoFile();
    const QByteArray program = QFile::encodeName(helperProgram("bolster-bench", "app/cli"));
    std::vector<std::string> all = {program.toStdString()};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<char*> argv;
    for (std::string& word : all)
        argv.push_back(word.data());
    argv.push_back(nullptr);
    ::execv(program.constData(), argv.data());
    printError("error: the program \"" + (program.isEmpty() ? "bolster-bench" : program.toStdString()) +
               "\", which measures for Bolster, cannot be started; install Bolster again");
    return otherFailure;
}

} // namespace bolster::cli
