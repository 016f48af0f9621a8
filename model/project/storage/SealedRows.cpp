#include "SealedRows.h"

#include <algorithm>
#include <vector>

namespace bolster {
namespace {

void appendNumber(std::string& bytes, std::uint64_t number)
{
    for (int shift = 0; shift < 64; shift += 8)
        bytes += static_cast<char>(number >> shift);
}

} // namespace

Hash rowHash(std::string_view table, std::span<const Value> columns, const Hash& chain)
{
    static thread_local std::string bytes; // its memory is used again: this runs for each row of a project
    bytes.assign(table);
    bytes += '\0';
    bytes += bytesOf(chain);
    for (const Value& value : columns) {
        bytes += static_cast<char>(value.type);
        appendNumber(bytes, value.type == Value::Type::Integer ? static_cast<std::uint64_t>(value.number)
                                                               : value.bytes.size());
        bytes += value.bytes;
    }
    return hashOf(bytes);
}

Hash hashFrom(std::string_view bytes)
{
    Hash hash;
    if (bytes.size() != hash.size())
        throw DatabaseError({QT_TRANSLATE_NOOP("Message", "a checksum is incomplete")});
    std::copy(bytes.begin(), bytes.end(), hash.begin());
    return hash;
}

Hash SealedRows::put(const std::string& table, std::initializer_list<Value> columns, const Hash& chain)
{
    erase(table, columns.begin()->number);
    const Hash hash = rowHash(table, {columns.begin(), columns.size()}, chain);
    std::string sql = "INSERT INTO " + table + " VALUES(";
    for (std::size_t i = 0; i < columns.size(); ++i)
        sql += "?, ";
    Query insert(m_database, (sql + "?)").c_str(), std::span(columns.begin(), columns.size()),
                 Value::blob(bytesOf(hash)));
    insert.run();
    m_seal.add(hash);
    return hash;
}

void SealedRows::erase(const std::string& table, std::int64_t key)
{
    Query old(m_database, ("SELECT row_hash FROM " + table + " WHERE rowid = ?").c_str(), {Value::integer(key)});
    if (!old.next())
        return;
    m_seal.remove(hashFrom(old.blob(0)));
    m_database.run(("DELETE FROM " + table + " WHERE rowid = ?").c_str(), {Value::integer(key)});
}

void SealedRows::close(std::int64_t currentNode)
{
    const Hash seal = m_seal.value();
    const Value columns[] = {Value::integer(0), Value::integer(currentNode), Value::blob(bytesOf(seal))};
    const Hash hash = rowHash("state", columns);
    m_database.run("INSERT OR REPLACE INTO state VALUES(?, ?, ?, ?)",
                   {columns[0], columns[1], columns[2], Value::blob(bytesOf(hash))});
}

void eachRow(Database& database, const std::string& table, HashSum& seal,
             const std::function<void(std::span<const Value>, const Hash&)>& row,
             const std::function<Hash(std::span<const Value>)>& chain)
{
    Query query(database, ("SELECT * FROM " + table + " ORDER BY rowid").c_str());
    const auto count = static_cast<std::size_t>(query.columns());
    std::vector<Value> values(count);
    while (query.next()) {
        for (std::size_t i = 0; i < count; ++i)
            values[i] = query.value(static_cast<int>(i));
        const std::span<const Value> columns(values.data(), count - 1);
        const bool whole = values.back().type == Value::Type::Blob && values.back().bytes.size() == Hash().size();
        const Hash hash = whole ? hashFrom(values.back().bytes) : Hash{};
        if (hash != rowHash(table, columns, chain ? chain(columns) : Hash{}))
            throw DatabaseError(
                {QT_TRANSLATE_NOOP("Message",
                                   "\"%1\" is damaged: row %2 of the table \"%3\" is not what was written"),
                 {database.name().toStdString(), std::to_string(columns[0].number), table}});
        seal.add(hash);
        row(columns, hash);
    }
}

} // namespace bolster
