// The rows of a damaged project, as far as they can be read. Private to the library.
#pragma once

#include "SealedRows.h"

#include <map>
#include <set>

namespace bolster {

/// A row with values of the right kinds; its hash may still be wrong.
class SalvagedRow {
public:
    SalvagedRow(std::string table, std::vector<Value> columns, const Hash& hash);

    std::int64_t number(std::size_t column) const { return m_columns[column].number; }
    const std::string& bytes(std::size_t column) const { return m_bytes[column]; }
    bool isNull(std::size_t column) const { return m_columns[column].type == Value::Type::Null; }
    Value value(std::size_t column) const;
    const Hash& hash() const { return m_hash; }
    bool trusted(const Hash& chain = {}) const;

private:
    std::string m_table;
    std::vector<Value> m_columns;     // without the hash; their bytes are those below
    std::vector<std::string> m_bytes; // a row stays when the next one is read
    Hash m_hash;
};

/// Asks only the tables that are ours to the letter: a column of another one may be computed, or not be there.
class SalvagedRows {
public:
    explicit SalvagedRows(Database& database);

    /// Those that are missing, or are something else.
    const std::set<std::string>& lostTables() const { return m_lost; }
    /// Every key that can be found: on from each place that cannot be read. Never negative.
    std::set<std::int64_t> keys(const std::string& table);
    /// The row, if there is one that can be read.
    std::optional<SalvagedRow> row(const std::string& table, std::int64_t key);
    Database& database() { return m_database; }

private:
    Database& m_database;
    std::set<std::string> m_lost;
};

} // namespace bolster
