#include "DistinctFiles.h"

#include "Arguments.h"
#include "Output.h"
#include "WholeFile.h"

#include <QFileInfo>

namespace bolster::cli {

namespace {

/// Where a path leads to; of what is not there yet, where it will be.
QString placeOf(const QString& path)
{
    const QFileInfo info(path);
    if (info.exists())
        return info.canonicalFilePath();
    return QFileInfo(info.absolutePath()).canonicalFilePath() + "/" + info.fileName();
}

} // namespace

void expectDistinct(const QStringList& inputs, const QStringList& outputs)
{
    QStringList taken;
    for (const QString& input : inputs)
        if (!input.isEmpty())
            taken << placeOf(input);
    for (const QString& output : outputs) {
        if (output.isEmpty() || (QFileInfo::exists(output) && !QFileInfo(output).isFile()))
            continue; // "/dev/stdout" may be two of them
        if (taken.contains(placeOf(output)))
            throw UsageError("\"" + output.toStdString() + "\" is read, or written twice: choose another name");
        taken << placeOf(output);
    }
}

bool writeAndSay(const QString& path, const std::string& text)
{
    if (const Message problem = replaceWholeFile(path, text); !problem.empty()) {
        printError("error: " + problem.english());
        return false;
    }
    printResult("wrote " + path.toStdString());
    return true;
}

} // namespace bolster::cli
