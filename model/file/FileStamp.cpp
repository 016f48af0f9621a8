#include "FileStamp.h"

#include "DiskFile.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QStringList>

#include <limits>

namespace bolster {
namespace {

QByteArray contentHash(const QString& path)
{
    constexpr std::size_t hashedAtOnce = 1 << 20;
    Message problem;
    const auto file = DiskFile::open(path, std::numeric_limits<std::int64_t>::max(), problem);
    if (!file)
        return {};
    QCryptographicHash hash(QCryptographicHash::Blake2b_256);
    std::string bytes(hashedAtOnce, '\0');
    std::int64_t got = 0;
    for (std::uint64_t at = 0; (got = file->read(at, bytes.data(), bytes.size())) > 0;
         at += static_cast<std::uint64_t>(got))
        hash.addData(QByteArrayView(bytes.data(), got));
    return hash.result();
}

} // namespace

FileStamp stampOf(const QString& path, bool withContent)
{
    return {true, QFileInfo(path).symLinkTarget(), withContent ? contentHash(path) : QByteArray()};
}

bool isTaken(const QString& path)
{
    const QFileInfo file(path);
    return file.exists() || file.isSymLink();
}

QString textOf(const FileStamp& stamp)
{
    if (!stamp.known)
        return {};
    return QStringLiteral("file %1 %2")
        .arg(QString::fromLatin1(stamp.link.toUtf8().toHex()), QString::fromLatin1(stamp.content.toHex()));
}

FileStamp stampFrom(const QString& text)
{
    const QStringList words = text.split(u' ');
    if (words.size() != 3 || words[0] != QLatin1String("file"))
        return {};
    return {true, QString::fromUtf8(QByteArray::fromHex(words[1].toLatin1())),
            QByteArray::fromHex(words[2].toLatin1())};
}

} // namespace bolster
