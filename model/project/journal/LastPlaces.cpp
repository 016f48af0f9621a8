#include "LastPlaces.h"

#include "WholeFile.h"

#include <QDir>
#include <QStandardPaths>

namespace bolster::lastPlaces {
namespace {

constexpr qsizetype mostPlaces = 100;
constexpr std::int64_t longestPlace = 1'000;

QString placesFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/places");
}

QString placeFile(const std::string& uuid)
{
    return placesFolder() + '/' + QByteArray::fromStdString(uuid).toHex();
}

QByteArray sealText(const Hash& seal)
{
    return QByteArray(reinterpret_cast<const char*>(seal.data()), static_cast<qsizetype>(seal.size())).toHex();
}

} // namespace

void keep(const std::string& uuid, const Hash& seal, NodeId node)
{
    const QDir folder(placesFolder());
    folder.mkpath(".");
    (void)replaceWholeFile(placeFile(uuid), (sealText(seal) + ' ' + QByteArray::number(node)).toStdString());
    const QStringList all = folder.entryList(QDir::Files, QDir::Time);
    for (const QString& old : all.mid(mostPlaces))
        QFile::remove(folder.filePath(old));
}

void forget(const std::string& uuid)
{
    QFile::remove(placeFile(uuid));
}

std::optional<NodeId> find(const std::string& uuid, const Hash& seal)
{
    const QByteArray text = QByteArray::fromStdString(readWholeFile(placeFile(uuid), longestPlace).bytes);
    const QList<QByteArray> words = text.split(' ');
    bool number = false;
    const NodeId node = words.value(1).toInt(&number);
    return number && words.value(0) == sealText(seal) ? std::optional(node) : std::nullopt;
}

} // namespace bolster::lastPlaces
