#include "Commands.h"
#include "Journal.h"
#include "Output.h"
#include "WholeFile.h"

#include <QFileInfo>
#include <QTemporaryDir>

namespace bolster::cli {

const char* const importHelp = R"(Usage: bolster import DESIGN FILE

Makes a new project FILE of a design (JSON), with the frames and scans that it
names. What cannot be read of the design is kept in it, and reported.

Exit code:
  0  done; elements with errors are reported, and are in the project as they are
  1  FILE is there already, or cannot be written
  2  DESIGN cannot be read
)";

namespace {

constexpr std::int64_t largestImported = 64'000'000;

/// Reports files that are not there: the project goes without them.
Message addFiles(Journal& journal, const Design& design, const QString& folder)
{
    for (const auto& [id, element] : design.elements()) {
        const std::string* file = elementFile(*element);
        if (!file)
            continue;
        Message missing;
        const QString path = elementFilePath(*element, folder, missing);
        std::string name = *file;
        if (missing.empty())
            if (Message problem = journal.addAsset(name, path); !problem.empty())
                return problem;
        if (!missing.empty())
            printProblems(
                {{id, elementLabel(id, *element), elementFileField(*element), missing, Severity::Warning}});
    }
    return {};
}

Message writeProject(const Design& design, const QString& folder, const QString& target)
{
    const QTemporaryDir work;
    const Journal::Opened opened = Journal::create(work.filePath("journal"), design);
    if (!opened.journal)
        return opened.project.problem;
    if (Message problem = addFiles(*opened.journal, design, folder); !problem.empty())
        return problem;
    return opened.journal->save(target);
}

} // namespace

int importDesign(std::span<const std::string> words)
{
    const std::vector<QString> files = Arguments(words, {}).files({"DESIGN", "FILE"});
    if (QFileInfo::exists(files[1])) {
        printError("error: \"" + files[1].toStdString() + "\" is there already; choose another name");
        return otherFailure;
    }
    const WholeFile text = readWholeFile(files[0], largestImported);
    if (!text.problem.empty()) {
        printError("error: " + text.problem.english());
        return badInput;
    }
    const ReadDesign read = readDesign(text.bytes);
    printProblems(read.problems);
    if (!read.readable)
        return badInput;
    if (const Message problem = writeProject(read.design, QFileInfo(files[0]).absolutePath(), files[1]);
        !problem.empty()) {
        printError("error: " + problem.english());
        return otherFailure;
    }
    printResult("wrote " + files[1].toStdString());
    return done;
}

} // namespace bolster::cli
