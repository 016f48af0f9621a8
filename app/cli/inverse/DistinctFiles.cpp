#include "DistinctFiles.h"

#include "Arguments.h"

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

} // namespace bolster::cli
