// Rows that notice when they are changed. Private to the library.
#pragma once

#include "Database.h"
#include "Hash.h"

#include <functional>
#include <span>

namespace bolster {

/// The last column of each table but `chunk` and `thumbnail` is the hash of its name and all other columns; that of
/// a node covers its parent's hash, too (`chain`).
Hash rowHash(std::string_view table, std::span<const Value> columns, const Hash& chain = {});

/// Throws when it is not as long as a hash.
Hash hashFrom(std::string_view bytes);

/// The tables whose rows are sealed; `state` holds the seal: the sum of their hashes. So a row that has vanished is
/// noticed, too.
inline constexpr const char* sealedTables[] = {"project",  "node",       "label", "redo",
                                               "snapshot", "save_point", "asset", "blob"};

/// Writes rows, and keeps the seal right. To be used within one transaction.
class SealedRows {
public:
    SealedRows(Database& database, const HashSum& seal)
        : m_database(database)
        , m_seal(seal)
    {}

    /// Adds the row, or puts it in the place of the one with this key, the first column. Returns its hash.
    Hash put(const std::string& table, std::initializer_list<Value> columns, const Hash& chain = {});
    void erase(const std::string& table, std::int64_t key);
    /// Writes `state`: the current node, and the seal. The last thing of a transaction.
    void close(std::int64_t currentNode);
    const HashSum& seal() const { return m_seal; }

private:
    Database& m_database;
    HashSum m_seal;
};

/// Calls row(columns without the hash, hash) for each row of a table, by key. `chain` gives what the hash of the
/// row covers besides. Throws when a hash is wrong.
void eachRow(Database& database, const std::string& table, HashSum& seal,
             const std::function<void(std::span<const Value>, const Hash&)>& row,
             const std::function<Hash(std::span<const Value>)>& chain = {});

} // namespace bolster
