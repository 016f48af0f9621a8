#include "DiskFile.h"
#include "Interrupt.h"
#include "Journal.h"
#include "Output.h"
#include "Subcommands.h"
#include "Unfinished.h"

#include <QFileInfo>

#include <set>

namespace bolster::cli {

const char* const importHelp = R"(Usage: bolster import DESIGN FILE

Makes a new project FILE of a design (JSON), with the frames and scans that it
names. What cannot be read of the design is kept in it, and reported; so are
elements whose files are missing or hold something else.

Exit code:
  0  done; elements with errors are reported, and are in the project as they are
  1  FILE is there already, or cannot be written, or interrupted
  2  DESIGN cannot be read
)";

namespace {

/// The project goes without files that cannot be taken into it: that has been reported.
Message addFiles(Journal& journal, const Design& design, const QString& folder, const std::stop_token& stop)
{
    std::set<std::string> known; // many elements may have one file
    for (const auto& [id, element] : design.elements()) {
        const std::string* file = elementFile(*element);
        if (!file || !known.insert(*file).second || stop.stop_requested())
            continue;
        Message missing;
        const QString path = elementFilePath(*element, folder, missing);
        if (missing.empty())
            missing = ordinaryFileProblem(path);
        std::string name = *file;
        if (missing.empty())
            if (Message problem = journal.addAsset(name, path); !problem.empty())
                return problem;
    }
    return {};
}

Message writeProject(const Design& design, const QString& folder, const QString& target,
                     const std::stop_token& stop)
{
    const WorkFolder work;
    const Journal::Opened opened = Journal::create(work.filePath("journal"), design);
    if (!opened.journal)
        return opened.project.problem;
    if (Message problem = addFiles(*opened.journal, design, folder, stop); !problem.empty())
        return problem;
    return stop.stop_requested() ? Message{"interrupted", {}} : opened.journal->save(target);
}

} // namespace

int importDesign(std::span<const std::string> words)
{
    const std::vector<QString> files = Arguments(words, {}).files({"DESIGN", "FILE"});
    if (QFileInfo::exists(files[1])) {
        printError("error: \"" + files[1].toStdString() + "\" is there already; choose another name");
        return otherFailure;
    }
    const Interrupt interrupt;
    const ReadDesign read = readDesignFile(files[0]);
    if (!read.readable) {
        printProblems(read.problems);
        return badInput;
    }
    const QString folder = QFileInfo(files[0]).absolutePath();
    printProblems(openReadDesign(read, folder, interrupt.token()).problems);
    if (const Message problem = writeProject(read.design, folder, files[1], interrupt.token()); !problem.empty()) {
        printError("error: " + problem.english());
        return otherFailure;
    }
    printResult("wrote " + files[1].toStdString());
    return done;
}

} // namespace bolster::cli
