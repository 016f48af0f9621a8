#include "Samples.h"

#include "ProgramPlace.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QSet>

namespace bolster {

namespace {

const QString indexName = QStringLiteral("samples.json");

QList<Sample> fromIndex(const QDir& folder)
{
    QFile file(folder.filePath(indexName));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QString language = QLocale().name().section(u'_', 0, 0);
    QList<Sample> found;
    for (const QJsonValue& value : QJsonDocument::fromJson(file.readAll()).array()) {
        const QJsonObject entry = value.toObject();
        const QJsonObject words = entry.value(language).toObject(entry);
        const QString path = folder.filePath(entry.value(QStringLiteral("file")).toString());
        if (QFileInfo(path).isFile())
            found.append({path, words.value(QStringLiteral("title")).toString(),
                          words.value(QStringLiteral("description")).toString()});
    }
    return found;
}

} // namespace

/// A build has a link to those of the sources.
QString shippedFolder(const std::string& name)
{
    const std::filesystem::path program = programFolder();
    const std::filesystem::path build = buildAround(program);
    for (const std::filesystem::path& folder :
         {program.empty() ? program : program / ".." / "share" / "bolster" / name,
          build.empty() ? build : build / name})
        if (const QString path = QString::fromStdString(folder.string()); !path.isEmpty() && QDir(path).exists())
            return QDir(path).canonicalPath();
    return {};
}

QString samplesFolder()
{
    return shippedFolder("samples");
}

QList<Sample> samples(const QString& folder)
{
    if (folder.isEmpty())
        return {};
    const QDir dir(folder);
    QList<Sample> found = fromIndex(dir);
    QSet<QString> known;
    for (const Sample& sample : found)
        known.insert(QFileInfo(sample.path).canonicalFilePath());
    QFileInfoList files = dir.entryInfoList({QStringLiteral("*.json")}, QDir::Files, QDir::Name);
    for (const QFileInfo& sub : dir.entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name))
        files.append(QFileInfo(QDir(sub.filePath()).filePath(sub.fileName() + QStringLiteral(".json"))));
    for (const QFileInfo& file : files)
        if (file.isFile() && file.fileName() != indexName && !known.contains(file.canonicalFilePath()))
            found.append({file.filePath(), file.completeBaseName(), {}});
    return found;
}

QString titleOf(const QString& path)
{
    const QString file = QFileInfo(path).canonicalFilePath();
    for (const Sample& sample : samples())
        if (QFileInfo(sample.path).canonicalFilePath() == file)
            return sample.title;
    return QFileInfo(path).completeBaseName();
}

bool isSample(const QString& path)
{
    const QString folder = samplesFolder();
    // The file itself need not be there: copies of unsaved work name one that never was.
    const QString place = QDir(QFileInfo(path).absolutePath()).canonicalPath() + u'/';
    return !folder.isEmpty() && place.startsWith(folder + u'/');
}

} // namespace bolster
