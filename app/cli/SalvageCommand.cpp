#include "Interrupt.h"
#include "Output.h"
#include "ProgressLine.h"
#include "Salvage.h"
#include "Subcommands.h"

namespace bolster::cli {

const char* const salvageHelp = R"(Usage: bolster salvage FILE OUT

Makes a new project OUT of all that can be trusted in a damaged one: the edits
from the first one on whose hashes are right, with all branches, and versions
from after a gap. Says what is lost. FILE is not changed.

Exit code:
  0  OUT is a sound project now
  1  OUT is there already, or cannot be written
  2  nothing in FILE can be saved
)";

int salvage(std::span<const std::string> words)
{
    const std::vector<QString> files = Arguments(words, {}).files({"FILE", "OUT"});
    const Interrupt interrupt;
    const Salvaged salvaged = [&] {
        const ProgressLine line("recovering what can be read");
        return salvageProject(files[0], files[1], interrupt.token());
    }();
    if (!salvaged.problem.empty()) {
        printError("error: " + salvaged.problem.english());
        return salvaged.readable ? otherFailure : badInput;
    }
    for (const Message& note : salvaged.notes)
        printResult(note.english());
    return done;
}

} // namespace bolster::cli
