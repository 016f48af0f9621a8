#include "SalvageRows.h"

#include "Schema.h"

#include <new>

namespace bolster {
namespace {

/// What the columns hold: numbers, texts, bytes; in capitals where there may be nothing. The last one is the hash.
const std::map<std::string, std::string_view> kindsOf = {
    {"node", "ibIiitbbbb"}, {"label", "iTTib"}, {"snapshot", "iibb"}, {"asset", "itib"}, {"state", "iibb"}};

bool isOfKind(const Value& value, char kind)
{
    switch (value.type) {
    case Value::Type::Null:
        return kind == 'I' || kind == 'T';
    case Value::Type::Integer:
        return kind == 'i' || kind == 'I';
    case Value::Type::Text:
        return kind == 't' || kind == 'T';
    case Value::Type::Blob:
        return kind == 'b';
    }
    return false;
}

} // namespace

SalvagedRow::SalvagedRow(std::string table, std::vector<Value> columns, const Hash& hash)
    : m_table(std::move(table))
    , m_columns(std::move(columns))
    , m_hash(hash)
{
    for (Value& column : m_columns) {
        m_bytes.emplace_back(column.bytes);
        column.bytes = {};
    }
}

Value SalvagedRow::value(std::size_t column) const
{
    Value value = m_columns[column];
    value.bytes = m_bytes[column];
    return value;
}

bool SalvagedRow::trusted(const Hash& chain) const
{
    std::vector<Value> values;
    for (std::size_t i = 0; i < m_columns.size(); ++i)
        values.push_back(value(i));
    return rowHash(m_table, values, chain) == m_hash;
}

SalvagedRows::SalvagedRows(Database& database)
    : m_database(database)
{
    const std::set<std::string> sound = tablesAsTheyShouldBe(database);
    for (const char* table : {"node", "label", "snapshot", "asset", "state", "blob", "chunk"})
        if (!sound.contains(table))
            m_lost.insert(table);
}

std::set<std::int64_t> SalvagedRows::keys(const std::string& table)
{
    constexpr int longestGap = 10'000; // keys tried one by one
    std::set<std::int64_t> keys;
    if (m_lost.contains(table))
        return keys;
    const std::string sql = "SELECT rowid FROM " + table + " WHERE rowid >= ? ORDER BY rowid";
    std::int64_t next = 0;
    for (int gap = 0; gap < longestGap; ++gap) {
        try {
            Query query(m_database, sql.c_str(), {Value::integer(next)});
            while (query.next()) {
                const std::int64_t key = query.integer(0);
                if (key < next || key == std::numeric_limits<std::int64_t>::max())
                    return keys; // the pages go round in circles
                keys.insert(key);
                next = key + 1;
                gap = 0;
            }
            break;
        } catch (const DatabaseError&) {
            ++next;
        }
    }
    return keys;
}

std::optional<SalvagedRow> SalvagedRows::row(const std::string& table, std::int64_t key)
{
    if (m_lost.contains(table))
        return std::nullopt;
    const std::string_view kinds = kindsOf.at(table);
    try {
        Query query(m_database, ("SELECT * FROM " + table + " WHERE rowid = ?").c_str(), {Value::integer(key)});
        if (!query.next() || query.columns() != static_cast<int>(kinds.size()))
            return std::nullopt;
        std::vector<Value> columns;
        for (int i = 0; i < query.columns(); ++i) {
            columns.push_back(query.value(i));
            if (!isOfKind(columns.back(), kinds[static_cast<std::size_t>(i)]))
                return std::nullopt;
        }
        const Hash hash = hashFrom(columns.back().bytes);
        columns.pop_back();
        return SalvagedRow(table, std::move(columns), hash);
    } catch (const DatabaseError&) { // it is lost
        return std::nullopt;
    } catch (const std::bad_alloc&) { // it claims to be longer than memory
        return std::nullopt;
    }
}

} // namespace bolster
