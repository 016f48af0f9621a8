#include "DistinctFiles.h"

#include "Arguments.h"
#include "Output.h"
#include "TemporaryFile.h"
#include "WholeFile.h"

#include <QDir>
#include <QFileInfo>

#include <set>

namespace bolster::cli {

void expectDistinct(const QStringList& inputs, const QStringList& outputs)
{
    QStringList taken;
    for (const QString& input : inputs)
        if (!input.isEmpty())
            taken << fileKey(input);
    for (const QString& output : outputs) {
        if (output.isEmpty() || (QFileInfo::exists(output) && !QFileInfo(output).isFile()))
            continue; // "/dev/stdout" may be two of them
        if (taken.contains(fileKey(output)))
            throw UsageError("\"" + output.toStdString() + "\" is read, or written twice: choose another name");
        taken << fileKey(output);
    }
}

bool isThere(const QString& path)
{
    const QFileInfo file(path);
    return file.isSymLink() || file.isFile() || file.isDir(); // devices and pipes are written to
}

void sayOfFiles(const Design& design, const QString& readFrom, const QString& written)
{
    const QDir from = QFileInfo(readFrom).absoluteDir(), to = QFileInfo(written).absoluteDir();
    if (from.canonicalPath() == to.canonicalPath())
        return;
    std::set<std::string> missing;
    for (const auto& [id, element] : design.elements())
        if (const std::string* file = elementFile(*element); file && !to.exists(QString::fromStdString(*file)))
            missing.insert(*file);
    if (missing.empty())
        return;
    std::string names;
    for (const std::string& name : missing)
        names += (names.empty() ? "" : ", ") + name;
    printError("warning: the design names files that are not beside it now: copy " + names + " from " +
               from.path().toStdString() + " to " + to.path().toStdString());
}

namespace {

bool sayWritten(const QString& path, const Message& problem)
{
    if (problem.empty())
        printResult("wrote " + path.toStdString());
    else
        printError("error: " + problem.english());
    removeLeftTemporaryFiles(QFileInfo(resolved(path)).absolutePath());
    return problem.empty();
}

} // namespace

bool writeAndSay(const QString& path, const std::string& text)
{
    return sayWritten(path, replaceWholeFile(path, text));
}

bool writeNewAndSay(const QString& path, const std::string& text)
{
    return sayWritten(path, createWholeFile(path, text));
}

bool writeWithReport(const QString& path, const std::string& design, const QString& reportPath,
                     const std::string& report)
{
    const bool isThere = writeNewAndSay(path, design);
    return (reportPath.isEmpty() || writeAndSay(reportPath, report)) && isThere;
}

} // namespace bolster::cli
