#include "DistinctFiles.h"

#include "Arguments.h"
#include "Output.h"
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
