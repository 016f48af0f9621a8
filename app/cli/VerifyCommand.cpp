#include "Output.h"
#include "Project.h"
#include "Subcommands.h"

#include <array>

namespace bolster::cli {

const char* const verifyHelp = R"(Usage: bolster verify FILE [--all]

Looks for damage in a project: every row, every file in it, and the design after
every edit. Of a long history of large designs that would take long: then the last
line says how many designs were looked at. FILE is not changed.

  --all   the design after every edit, however long that takes

Exit code:
  0  sound
  2  damaged, or no project; "bolster salvage" gets out what is left
  3  nothing wrong was found, but not all designs were looked at
)";

namespace {

constexpr std::array verifyRules = {OptionRule{"--all", false}};

} // namespace

int verify(std::span<const std::string> words)
{
    const Arguments arguments(words, verifyRules);
    const QString path = arguments.onlyFile("FILE");
    const OpenedProject project =
        openProject(path, arguments.has("--all") ? ProjectCheck::Everything : ProjectCheck::Thorough);
    if (!project.problem.empty()) {
        printError("error: " + damageAdvice(project, path).english());
        return badInput;
    }
    const std::string contents = counted(project.history.count() - 1, "edit") + ", " +
                                 counted(static_cast<std::int64_t>(project.assets.size()), "file");
    if (project.designsChecked == project.history.count()) {
        printResult("sound: " + contents);
        return done;
    }
    printResult("sound as far as was looked: " + contents + "; of the designs, the present one and the first " +
                std::to_string(project.designsChecked) + " of " + std::to_string(project.history.count()) +
                " (--all looks at all of them, which takes long)");
    return partlyLooked;
}

} // namespace bolster::cli
