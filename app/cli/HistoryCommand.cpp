#include "Output.h"
#include "Project.h"
#include "Subcommands.h"

namespace bolster::cli {

const char* const historyHelp = R"(Usage: bolster history FILE

Lists the edits of a project, one per line, the oldest first: the number of the
edit and of the one before it, when it was made, the beginnings of two hashes
(of the design after it, and of the edit with all before it), what was done, and
the name of the branch that begins there in brackets, and that of the version in
quotes, if they have one. "*" is the current one.

Exit code:
  0  done
  2  FILE is damaged, or no project
)";

int history(std::span<const std::string> words)
{
    const QString path = Arguments(words, {}).onlyFile("FILE");
    const OpenedProject project = openProject(path);
    if (!project.problem.empty()) {
        printError("error: " + damageAdvice(project, path).english());
        return badInput;
    }
    for (NodeId id = 0; id < project.history.count(); ++id) {
        const History::Node& node = project.history.node(id);
        const ProjectNode& stored = project.nodes[static_cast<std::size_t>(id)];
        std::string line = id == project.history.current() ? "* " : "  ";
        line.append(std::to_string(id)).append(" ");
        line.append(id == 0 ? "-" : std::to_string(node.parent)).append(" ");
        line.append(node.time.toUTC().toString(Qt::ISODate).toStdString()).append(" ");
        line.append(hexText(stored.designHash).substr(0, 12)).append(" ");
        line.append(hexText(stored.rowHash).substr(0, 12)).append(" ");
        line.append(id == 0 ? "(begin)" : node.edit.verb.english());
        if (!node.branch.empty())
            line.append(" [").append(node.branch).append("]");
        if (!node.name.empty())
            line.append(" \"").append(node.name).append("\"");
        printResult(line);
    }
    return done;
}

} // namespace bolster::cli
