#include "Escaped.h"
#include "Interrupt.h"
#include "Output.h"
#include "Project.h"
#include "Subcommands.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>

namespace bolster::cli {

const char* const dumpHelp = R"(Usage: bolster dump FILE [options]

Writes the design of a project to stdout as canonical text (JSON): the same
design gives the same bytes, so that versions can be compared. FILE may be a
text, too. "bolster import" makes a project of it again.

Options:
  --history       write all versions: {"format": "bolster-history", "nodes":
                  [...], "design": {...}}, a line for each edit
  --assets DIR    write the frames and scans in the project into DIR; none of
                  them may be there already

Exit code:
  0  done
  1  an output cannot be written
  2  FILE is damaged, or neither a project nor a design
)";

namespace {

constexpr std::array dumpOptions = {OptionRule{"--history", false}, OptionRule{"--assets", true}};

std::string quoted(const std::string& text)
{
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// JSON as it is; a project from anybody may hold other text.
std::string valueText(const std::optional<std::string>& value)
{
    return !value ? "null" : nlohmann::json::accept(*value) ? *value : quoted(*value);
}

/// What is printed a piece at a time: a history may be much larger as text than it is.
class Printed {
public:
    Printed& operator<<(std::string_view text)
    {
        const std::string shown = escaped(text, Text::Json);
        m_good = m_good && std::fwrite(shown.data(), 1, shown.size(), stdout) == shown.size();
        return *this;
    }
    int end()
    {
        m_good = std::fflush(stdout) == 0 && m_good;
        if (!m_good)
            printError("error: the output cannot be written");
        return m_good ? done : otherFailure;
    }
    bool good() const { return m_good; }

private:
    bool m_good = true;
};

void printChanges(Printed& out, const FieldChanges& changes)
{
    out << "[";
    for (const FieldChange& change : changes) {
        out << (&change == changes.data() ? "[" : ", [") << std::to_string(number(change.element)) << ", "
            << quoted(change.field) << ", " << valueText(change.before) << ", " << valueText(change.after) << "]";
    }
    out << "]";
}

void printNode(Printed& out, const OpenedProject& project, NodeId id)
{
    const History::Node& node = project.history.node(id);
    const ProjectNode& stored = project.nodes[static_cast<std::size_t>(id)];
    const Message& verb = node.edit.verb;
    std::string args;
    for (const std::string& arg : verb.args)
        args.append(args.empty() ? "" : ", ").append(quoted(arg));
    std::string text = "{\"id\": ";
    text.append(std::to_string(id)).append(", \"parent\": ").append(id == 0 ? "null" : std::to_string(node.parent));
    text.append(", \"redo\": ");
    text.append(node.lastVisitedChild < 0 ? "null" : std::to_string(node.lastVisitedChild));
    text.append(", \"time\": ").append(quoted(node.time.toUTC().toString(Qt::ISODateWithMs).toStdString()));
    text.append(", \"run\": ").append(std::to_string(stored.run));
    text.append(", \"verb\": ").append(quoted(verb.key)).append(", \"args\": [").append(args).append("]");
    if (!node.name.empty())
        text.append(", \"name\": ").append(quoted(node.name));
    if (!node.branch.empty())
        text.append(", \"branch\": ").append(quoted(node.branch));
    text.append(", \"design_hash\": \"").append(hexText(stored.designHash));
    text.append("\", \"row_hash\": \"").append(hexText(stored.rowHash)).append("\", \"changes\": ");
    out << text;
    printChanges(out, storedChanges(project, id).value_or(FieldChanges()));
    out << "}";
}

int printHistory(const OpenedProject& project)
{
    Printed out;
    out << "{\"format\": \"bolster-history\", \"version\": 1, \"current\": "
        << std::to_string(project.history.current()) << ",\n \"nodes\": [";
    for (NodeId id = 0; id < project.history.count() && out.good(); ++id) {
        out << (id == 0 ? "\n  " : ",\n  ");
        printNode(out, project, id);
    }
    out << "],\n \"design\": " << writeDesign(project.design) << "}\n";
    return out.end();
}

int printDesign(const Design& design)
{
    return (Printed() << writeDesign(design)).end();
}

int refused(const Message& why)
{
    printError("error: " + why.english());
    return badInput;
}

int dumpText(const QString& path)
{
    const ReadDesign read = readDesignFile(path);
    printProblems(read.problems);
    return read.readable ? printDesign(read.design) : badInput;
}

} // namespace

int dump(std::span<const std::string> words)
{
    const Arguments arguments(words, dumpOptions);
    const QString path = arguments.onlyFile("FILE");
    const Interrupt interrupt; // removes what is half written out
    if (!looksLikeProject(path)) {
        if (arguments.has("--history") || arguments.has("--assets"))
            throw UsageError("only a project has a history and files, and \"" + path.toStdString() + "\" is none");
        return dumpText(path);
    }
    const OpenedProject project = openProject(path);
    if (!project.problem.empty())
        return refused(damageAdvice(project, path));
    if (arguments.has("--assets"))
        if (const Message problem = extractAllAssets(project, arguments.path("--assets")); !problem.empty()) {
            printError("error: " + problem.english());
            return otherFailure;
        }
    return arguments.has("--history") ? printHistory(project) : printDesign(project.design);
}

} // namespace bolster::cli
