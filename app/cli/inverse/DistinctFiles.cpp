#include "DistinctFiles.h"

#include "Arguments.h"
#include "Output.h"
#include "TemporaryFile.h"
#include "WholeFile.h"

#include <QFileInfo>

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

} // namespace bolster::cli
