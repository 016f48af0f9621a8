#include "Commands.h"
#include "Output.h"
#include "Project.h"

namespace bolster::cli {

const char* const verifyHelp = R"(Usage: bolster verify FILE

Looks for damage in a project: every row, the design after every edit, and every
file in it. FILE is not changed.

Exit code:
  0  sound
  2  damaged, or no project; "bolster salvage" gets out what is left
)";

int verify(std::span<const std::string> words)
{
    const QString path = Arguments(words, {}).onlyFile("FILE");
    const OpenedProject project = openProject(path, ProjectCheck::Everything);
    if (!project.problem.empty()) {
        printError("error: " + project.problem.english());
        return badInput;
    }
    printResult("sound: " + counted(project.history.count() - 1, "edit") + ", " +
                counted(static_cast<std::int64_t>(project.assets.size()), "file"));
    return done;
}

} // namespace bolster::cli
