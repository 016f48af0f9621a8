#include "BlobStore.h"

#include "Unfinished.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QStringDecoder>
#include <QTemporaryFile>

#include <algorithm>
#include <array>
#include <optional>

namespace bolster {
namespace {

constexpr qint64 chunkSize = 1 << 20;
constexpr std::int64_t mostChunks = 1 << 20;                    // of one content
constexpr std::int64_t mostBlobs = (std::int64_t{1} << 43) - 2; // so that the numbers of their pieces fit
constexpr std::int64_t pieceLimit = mostBlobs * mostChunks;
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

[[noreturn]] void refuse(const Database& database, std::int64_t blob)
{
    throw DatabaseError({QT_TRANSLATE_NOOP("Message", "\"%1\" is damaged: the content number %2 cannot be read"),
                         {database.name().toStdString(), std::to_string(blob)}});
}

/// Of a content that isBlobNumber().
std::int64_t chunkId(std::int64_t blob, std::int64_t index)
{
    return blob * mostChunks + index;
}

Hash resultOf(const QCryptographicHash& hash)
{
    const QByteArray bytes = hash.result();
    return hashFrom({bytes.data(), static_cast<std::size_t>(bytes.size())});
}

[[noreturn]] void refuseSource(const QIODevice& source)
{
    throw DatabaseError({QT_TRANSLATE_NOOP("Message", "a file that the design uses cannot be read (%1)"),
                         {source.errorString().toStdString()}});
}

Hash hashOfAll(QIODevice& source, std::int64_t& size)
{
    QCryptographicHash hash(QCryptographicHash::Blake2b_256);
    size = source.size();
    if (!hash.addData(&source))
        refuseSource(source);
    return resultOf(hash);
}

std::optional<std::int64_t> numberOf(Database& database, const Hash& content)
{
    Query same(database, "SELECT id FROM blob WHERE hash = ?", {Value::blob(bytesOf(content))});
    return same.next() ? std::optional(same.integer(0)) : std::nullopt;
}

/// -1 when there is none.
std::int64_t firstChunkFrom(Database& database, std::int64_t id)
{
    Query query(database, "SELECT id FROM chunk WHERE id >= ? ORDER BY id LIMIT 1", {Value::integer(id)});
    return query.next() ? query.integer(0) : -1;
}

/// One that nobody has, not even a content that is on its way.
std::int64_t nextNumber(Database& database)
{
    Query pieces(database, "SELECT coalesce(max(id), 0) FROM chunk WHERE id < ?", {Value::integer(pieceLimit)});
    const std::int64_t ofPieces = pieces.next() ? pieces.integer(0) / mostChunks : 0;
    const std::int64_t next = 1 + std::max(database.number("SELECT coalesce(max(id), 0) FROM blob"), ofPieces);
    if (!isBlobNumber(next))
        refuse(database, next);
    return next;
}

void removeUnlessKnown(Database& database, std::int64_t blob)
{
    database.run("DELETE FROM chunk WHERE id >= ? AND id < ? AND NOT EXISTS (SELECT 1 FROM blob WHERE id = ?)",
                 {Value::integer(chunkId(blob, 0)), Value::integer(chunkId(blob + 1, 0)), Value::integer(blob)});
}

} // namespace

NewBlob::NewBlob(Database& database, QIODevice& source)
    : m_database(database)
{
    m_hash = hashOfAll(source, m_size); // most files are there already: nothing is written then
    if (!numberOf(database, m_hash))
        store(source);
}

NewBlob::~NewBlob()
{
    try {
        if (m_number > 0)
            removeUnlessKnown(m_database, m_number);
    } catch (const DatabaseError&) { // the next save does it
    }
}

void NewBlob::store(QIODevice& source)
{
    QCryptographicHash hash(QCryptographicHash::Blake2b_256);
    m_size = 0;
    std::unique_lock turn(m_database); // until a piece keeps the number
    m_number = nextNumber(m_database);
    source.seek(0);
    for (std::int64_t index = 0; !source.atEnd(); ++index) {
        const QByteArray bytes = source.read(chunkSize);
        if (bytes.isEmpty() || index == mostChunks)
            refuseSource(source);
        const std::string_view view(bytes.data(), static_cast<std::size_t>(bytes.size()));
        m_database.run("INSERT INTO chunk VALUES(?, ?, ?)",
                       {Value::integer(chunkId(m_number, index)), Value::blob(view), Value::integer(crcOf(view))});
        if (turn)
            turn.unlock();
        hash.addData(bytes);
        m_size += bytes.size();
    }
    m_hash = resultOf(hash);
}

std::int64_t NewBlob::finish(SealedRows& rows)
{
    if (const auto same = numberOf(m_database, m_hash))
        return *same;
    if (m_size == 0) // no piece has kept the number
        m_number = nextNumber(m_database);
    rows.put("blob", {Value::integer(m_number), Value::blob(bytesOf(m_hash)), Value::integer(m_size)});
    return m_number;
}

void removeUnfinishedBlobs(Database& database)
{
    for (std::int64_t next = 0;;) {
        const std::int64_t chunk = firstChunkFrom(database, chunkId(next, 0));
        if (chunk < 0)
            return;
        if (chunk >= pieceLimit) {
            database.run("DELETE FROM chunk WHERE id >= ?", {Value::integer(pieceLimit)});
            return;
        }
        removeUnlessKnown(database, chunk / mostChunks);
        next = chunk / mostChunks + 1;
    }
}

namespace {

struct BlobFacts {
    std::string hash;
    std::int64_t bytes = 0;
};

BlobFacts factsOf(Database& database, std::int64_t blob)
{
    Query facts(database, "SELECT hash, bytes FROM blob WHERE id = ?", {Value::integer(blob)});
    if (!facts.next())
        refuse(database, blob);
    return {std::string(facts.blob(0)), facts.integer(1)};
}

} // namespace

/// Other threads have their turn between the pieces: a scan may be large.
void readBlob(Database& database, std::int64_t blob, QIODevice* target)
{
    if (!isBlobNumber(blob))
        refuse(database, blob);
    const BlobFacts facts = factsOf(database, blob);
    QCryptographicHash hash(QCryptographicHash::Blake2b_256);
    std::int64_t size = 0;
    std::int64_t index = 0;
    for (; size < facts.bytes; ++index) {
        Query chunk(database, "SELECT data, crc FROM chunk WHERE id = ?", {Value::integer(chunkId(blob, index))});
        if (index == mostChunks || !chunk.next())
            refuse(database, blob);
        const std::string_view data = chunk.blob(0);
        if (data.empty() || chunk.integer(1) != crcOf(data))
            refuse(database, blob);
        const QByteArray bytes = QByteArray::fromRawData(data.data(), static_cast<qsizetype>(data.size()));
        hash.addData(bytes);
        size += bytes.size();
        if (target && target->write(bytes) != bytes.size())
            throw DatabaseError({QT_TRANSLATE_NOOP("Message", "a file of the project cannot be written out (%1)"),
                                 {target->errorString().toStdString()}});
    }
    const std::int64_t more = firstChunkFrom(database, chunkId(blob, index));
    if (size != facts.bytes || (more >= 0 && more < chunkId(blob + 1, 0)) || bytesOf(resultOf(hash)) != facts.hash)
        refuse(database, blob);
}

void extractBlob(Database& database, std::int64_t blob, const QString& path, FileThere there)
{
    QDir().mkpath(QFileInfo(path).absolutePath());
    QTemporaryFile file(path + QStringLiteral(".XXXXXX")); // whoever looks for the file finds all of it, or none
    const auto refuseUnless = [&](bool worked) {
        if (!worked)
            throw DatabaseError({QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written (%2)"),
                                 {path.toStdString(), file.errorString().toStdString()}});
    };
    refuseUnless(file.open());
    const Unfinished unfinished(file.fileName());
    readBlob(database, blob, &file);
    refuseUnless(file.flush());
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup | QFile::ReadOther);
    if (there == FileThere::Replace)
        QFile::remove(path);
    refuseUnless(file.rename(path)); // never over another file
    file.setAutoRemove(false);
}

void removeBlob(Database& database, SealedRows& rows, std::int64_t blob)
{
    rows.erase("blob", blob);
    database.run("DELETE FROM chunk WHERE id >= ? AND id < ?",
                 {Value::integer(chunkId(blob, 0)), Value::integer(chunkId(blob + 1, 0))});
}

bool isAssetName(const std::string& name)
{
    QStringDecoder utf8(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    const QString decoded = utf8(QByteArrayView(name.data(), static_cast<qsizetype>(name.size())));
    const QString clean = QDir::cleanPath(decoded);
    return !utf8.hasError() && !name.empty() && name.size() <= longestName &&
           name.find('\0') == std::string::npos && !QDir::isAbsolutePath(clean) && clean != "." && clean != ".." &&
           !clean.startsWith("../");
}

std::string assetPlace(const std::string& name)
{
    return QDir::cleanPath(QString::fromStdString(name)).toStdString();
}

bool isBlobNumber(std::int64_t blob)
{
    return blob >= 0 && blob < mostBlobs;
}

bool hasForeignChunks(Database& database)
{
    return database.number("SELECT count(*) FROM chunk WHERE id / 1048576 NOT IN (SELECT id FROM blob)") != 0;
}

} // namespace bolster
