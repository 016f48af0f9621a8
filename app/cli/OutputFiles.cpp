#include "OutputFiles.h"

#include "Output.h"
#include "TemporaryFile.h"
#include "WholeFile.h"

#include <QFile>
#include <QFileInfo>

#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace bolster::cli {
namespace {

bool isDevice(const QString& path)
{
    return QFileInfo::exists(path) && !QFileInfo(path).isFile();
}

/// Whether it is the pipe, the terminal or the file that stdout leads to.
bool isStandardOutput(const QString& path)
{
    struct stat there = {}, out = {};
    return ::stat(QFile::encodeName(path).constData(), &there) == 0 && ::fstat(STDOUT_FILENO, &out) == 0 &&
           there.st_dev == out.st_dev && there.st_ino == out.st_ino;
}

} // namespace

OutputFiles::OutputFiles(const Arguments& arguments, std::initializer_list<const char*> options)
{
    std::map<QString, std::string> taken;
    for (const char* const option : options) {
        if (!arguments.has(option))
            continue;
        const QString path = arguments.path(option);
        m_paths.emplace(option, path);
        const auto [other, isNew] = taken.emplace(fileKey(path), option);
        if (!isNew && !isDevice(path))
            throw UsageError(other->second + " and " + option + " are the same file");
        m_standardOutput = m_standardOutput || isStandardOutput(path);
    }
    if (m_standardOutput)
        sendResultsToErrors(true);
}

OutputFiles::~OutputFiles()
{
    if (m_standardOutput) // another list of outputs may have done so
        sendResultsToErrors(false);
}

void OutputFiles::protectInputs(const QString& designPath, const Design& design) const
{
    std::map<QString, std::string> inputs = {{fileKey(designPath), "the design"}};
    const QString folder = QFileInfo(designPath).absolutePath();
    for (const auto& [id, element] : design.elements())
        if (const std::string* file = elementFile(*element))
            inputs.emplace(fileKey(folder + "/" + QString::fromStdString(*file)),
                           "the file \"" + *file + "\" of " + elementLabel(id, *element));
    for (const auto& [option, path] : m_paths)
        if (const auto input = inputs.find(fileKey(path)); input != inputs.end() && QFileInfo(path).isFile())
            throw UsageError(option + " would overwrite " + input->second);
}

std::string whyNotWritten(const QString& path)
{
    if (isDevice(path) && !QFileInfo(path).isDir())
        return {}; // what is there takes what it takes
    const QFileInfo file(resolved(path)), folder(file.absolutePath());
    if (file.isDir())
        return "is a folder";
    if (!folder.isDir())
        return "lies in a folder that is not there";
    return folder.isWritable() ? "" : "cannot be written: you may not write into that folder";
}

namespace {

/// Prints why not; `option` as the line names it.
bool mayBeWritten(const std::string& option, const QString& path)
{
    const std::string why = whyNotWritten(path);
    if (!why.empty())
        printError("error: " + option + "\"" + path.toStdString() + "\" " + why);
    return why.empty();
}

} // namespace

bool canBeWritten(std::initializer_list<QString> paths)
{
    bool all = true;
    for (const QString& path : paths)
        all = (path.isEmpty() || mayBeWritten("", path)) && all;
    return all;
}

bool canBeMade(const QString& folder)
{
    QFileInfo there(folder);
    while (!folder.isEmpty() && !there.exists() && there.absolutePath() != there.absoluteFilePath())
        there.setFile(there.absolutePath());
    if (folder.isEmpty() || (there.isDir() && there.isWritable()))
        return true;
    printError("error: the folder \"" + folder.toStdString() + "\" cannot be made");
    return false;
}

bool OutputFiles::canBeWritten() const
{
    bool all = true;
    for (const auto& [option, path] : m_paths)
        all = mayBeWritten(option + ": ", path) && all;
    return all;
}

bool OutputFiles::write(const std::string& option, const std::function<Message(const QString&)>& writer) const
{
    const auto found = m_paths.find(option);
    if (found == m_paths.end())
        return true;
    if (!isDevice(found->second))
        removeLeftTemporaryFiles(QFileInfo(resolved(found->second)).absolutePath());
    const Message problem = writer(found->second);
    if (problem.empty())
        printResult("wrote " + found->second.toStdString());
    else
        printError("error: " + problem.english());
    return problem.empty();
}

} // namespace bolster::cli
