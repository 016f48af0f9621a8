#include "FabricBaking.h"
#include "FrameWarnings.h"
#include "Interrupt.h"
#include "Output.h"
#include "ProgressLine.h"
#include "Project.h"
#include "RestingSolve.h"
#include "Solving.h"
#include "Subcommands.h"

#include <algorithm>
#include <unistd.h>

namespace bolster::cli {

const char* const checkHelp = R"(Usage: bolster check DESIGN

Reads a design (JSON or a project), the frames and the pictures it names, and reports
everything that is wrong with it: one line for each problem on stderr, with element and field, and
the number of errors and warnings on stdout. A design without a patch is an error,
too: there is nothing to solve. Warnings of the cover (strain over its limits, folds,
off the frame), which the window lists, too, come from "bolster solve"; what there is to
mend before it is cut "bolster export" says. On a terminal a line reminds of that.

Exit code:
  0  no errors (warnings do not count)
  2  at least one error, or DESIGN cannot be read
)";

int check(std::span<const std::string> words)
{
    const QString path = Arguments(words, {}).onlyFile("DESIGN");
    const Interrupt interrupt;
    OpenedDesign opened = openedShown(path);
    if (opened.readable) {
        const ProgressLine line("checking");
        addNew(opened.problems, checkSolvable(opened.design));
        addNew(opened.problems, checkFrames({opened.design, opened.files}));
        addNew(opened.problems, pictureProblems(path, opened.design, interrupt.token()));
        addMissingPatch(opened.problems, opened.design);
    }
    std::stable_sort(opened.problems.begin(), opened.problems.end(),
                     [](const Problem& a, const Problem& b) { return a.element < b.element; });
    printProblems(opened.problems);
    printResult(countedProblems(opened.problems));
    if (::isatty(STDERR_FILENO) == 1 && !hasErrors(opened.problems)) // for people, not for scripts
        printError("(of the design alone; warnings of its cover come from \"bolster solve\")");
    return hasErrors(opened.problems) ? badInput : done;
}

} // namespace bolster::cli
