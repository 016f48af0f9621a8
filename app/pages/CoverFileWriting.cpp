#include "CoverFileWriting.h"

#include "WholeFile.h"

#include <QFileInfo>

namespace bolster {

Message writeCoverFile(const CoverFile& file, const QString& path,
                       const std::function<bool(const QString&)>& isInput)
{
    if (!file.problem.empty())
        return file.problem;
    const QString folder = QFileInfo(path).absolutePath() + u'/';
    for (const NamedFile& beside : file.beside) {
        const QString name = folder + QString::fromStdString(beside.name);
        if (name == QFileInfo(path).absoluteFilePath() || (QFileInfo::exists(name) && isInput(name)))
            return {QT_TRANSLATE_NOOP("Message", "\"%1\" would be replaced, which is needed; choose another name"),
                    {beside.name}};
    }
    for (const NamedFile& beside : file.beside)
        if (const Message problem = replaceWholeFile(folder + QString::fromStdString(beside.name), beside.bytes);
            !problem.empty())
            return problem;
    return replaceWholeFile(path, file.bytes);
}

} // namespace bolster
