#include "BlobStore.h"

#include <QCryptographicHash>
#include <QDir>

#include <algorithm>
#include <array>

namespace bolster {
namespace {

constexpr qint64 chunkSize = 1 << 20;
constexpr std::int64_t mostChunks = 1 << 20; // of one content
constexpr std::size_t longestName = 4096;

/// CRC-32 as in zlib and PNG.
std::int64_t crcOf(std::string_view bytes)
{
    static const auto table = [] {
        std::array<std::uint32_t, 256> result{};
        for (std::uint32_t i = 0; i < 256; ++i) {
            result[i] = i;
            for (int bit = 0; bit < 8; ++bit)
                result[i] = result[i] & 1 ? 0xEDB88320u ^ (result[i] >> 1) : result[i] >> 1;
        }
        return result;
    }();
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char byte : bytes)
        crc = table[(crc ^ static_cast<std::uint8_t>(byte)) & 0xFF] ^ (crc >> 8);
    return crc ^ 0xFFFFFFFFu;
}

[[noreturn]] void refuse(std::int64_t blob)
{
    throw DatabaseError({QT_TRANSLATE_NOOP("Message", "the content number %1 is damaged"), {std::to_string(blob)}});
}

std::int64_t chunkId(std::int64_t blob, std::int64_t index)
{
    return blob * mostChunks + index;
}

Hash resultOf(const QCryptographicHash& hash)
{
    const QByteArray bytes = hash.result();
    return hashFrom({bytes.data(), static_cast<std::size_t>(bytes.size())});
}

} // namespace

std::int64_t addBlob(Database& database, SealedRows& rows, QIODevice& source)
{
    const std::int64_t blob = database.number("SELECT coalesce(max(id), 0) + 1 FROM blob");
    QCryptographicHash hash(QCryptographicHash::Blake2b_256);
    std::int64_t size = 0;
    for (std::int64_t index = 0; !source.atEnd(); ++index) {
        const QByteArray bytes = source.read(chunkSize);
        if (bytes.isEmpty() || index == mostChunks)
            throw DatabaseError({QT_TRANSLATE_NOOP("Message", "a file that the design uses cannot be read (%1)"),
                                 {source.errorString().toStdString()}});
        const std::string_view view(bytes.data(), static_cast<std::size_t>(bytes.size()));
        database.run("INSERT INTO chunk VALUES(?, ?, ?)",
                     {Value::integer(chunkId(blob, index)), Value::blob(view), Value::integer(crcOf(view))});
        hash.addData(bytes);
        size += bytes.size();
    }
    const Hash content = resultOf(hash);
    Query same(database, "SELECT id FROM blob WHERE hash = ?", {Value::blob(bytesOf(content))});
    if (same.next()) {
        database.run("DELETE FROM chunk WHERE id >= ?", {Value::integer(chunkId(blob, 0))});
        return same.integer(0);
    }
    rows.put("blob", {Value::integer(blob), Value::blob(bytesOf(content)), Value::integer(size)});
    return blob;
}

void readBlob(Database& database, std::int64_t blob, QIODevice* target)
{
    Query facts(database, "SELECT hash, bytes FROM blob WHERE id = ?", {Value::integer(blob)});
    if (!facts.next())
        refuse(blob);
    QCryptographicHash hash(QCryptographicHash::Blake2b_256);
    std::int64_t size = 0;
    std::int64_t index = 0;
    Query chunks(database, "SELECT id, data, crc FROM chunk WHERE id >= ? AND id < ? ORDER BY id",
                 {Value::integer(chunkId(blob, 0)), Value::integer(chunkId(blob + 1, 0))});
    for (; chunks.next(); ++index) {
        const std::string_view data = chunks.blob(1);
        if (chunks.integer(0) != chunkId(blob, index) || chunks.integer(2) != crcOf(data))
            refuse(blob);
        const QByteArray bytes = QByteArray::fromRawData(data.data(), static_cast<qsizetype>(data.size()));
        hash.addData(bytes);
        size += bytes.size();
        if (target && target->write(bytes) != bytes.size())
            throw DatabaseError({QT_TRANSLATE_NOOP("Message", "a file of the project cannot be written out (%1)"),
                                 {target->errorString().toStdString()}});
    }
    if (size != facts.integer(1) || bytesOf(resultOf(hash)) != facts.blob(0))
        refuse(blob);
}

void removeBlob(Database& database, SealedRows& rows, std::int64_t blob)
{
    rows.erase("blob", blob);
    database.run("DELETE FROM chunk WHERE id >= ? AND id < ?",
                 {Value::integer(chunkId(blob, 0)), Value::integer(chunkId(blob + 1, 0))});
}

bool isAssetName(const std::string& name)
{
    const QString clean = QDir::cleanPath(QString::fromStdString(name));
    return !name.empty() && name.size() <= longestName && name.find('\0') == std::string::npos &&
           !QDir::isAbsolutePath(clean) && clean != "." && clean != ".." && !clean.startsWith("../");
}

} // namespace bolster
