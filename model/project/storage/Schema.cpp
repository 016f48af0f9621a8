#include "Schema.h"

#include <algorithm>
#include <vector>

namespace bolster {
namespace {

// Each table has one whole number as its key: so there is no index that could contradict its table.
constexpr const char* tables[] = {
    "CREATE TABLE project(id INTEGER PRIMARY KEY, uuid BLOB NOT NULL, writer TEXT NOT NULL, base BLOB, "
    "row_hash BLOB NOT NULL) STRICT",
    "CREATE TABLE node(id INTEGER PRIMARY KEY, uid BLOB NOT NULL, parent INTEGER, at INTEGER NOT NULL, "
    "run INTEGER NOT NULL, verb TEXT NOT NULL, args BLOB NOT NULL, patch BLOB NOT NULL, doc_hash BLOB NOT NULL, "
    "row_hash BLOB NOT NULL) STRICT",
    "CREATE TABLE label(node INTEGER PRIMARY KEY, version TEXT, branch TEXT, hidden INTEGER NOT NULL, "
    "row_hash BLOB NOT NULL) STRICT",
    "CREATE TABLE redo(parent INTEGER PRIMARY KEY, child INTEGER NOT NULL, row_hash BLOB NOT NULL) STRICT",
    "CREATE TABLE snapshot(node INTEGER PRIMARY KEY, codec INTEGER NOT NULL, data BLOB NOT NULL, "
    "row_hash BLOB NOT NULL) STRICT",
    "CREATE TABLE save_point(id INTEGER PRIMARY KEY, at INTEGER NOT NULL, node INTEGER NOT NULL, "
    "row_hash BLOB NOT NULL) STRICT",
    "CREATE TABLE asset(id INTEGER PRIMARY KEY, name TEXT NOT NULL, blob INTEGER NOT NULL, "
    "row_hash BLOB NOT NULL) STRICT",
    "CREATE TABLE blob(id INTEGER PRIMARY KEY, hash BLOB NOT NULL, bytes INTEGER NOT NULL, "
    "row_hash BLOB NOT NULL) STRICT",
    "CREATE TABLE chunk(id INTEGER PRIMARY KEY, data BLOB NOT NULL, crc INTEGER NOT NULL) STRICT",
    "CREATE TABLE thumbnail(node INTEGER PRIMARY KEY, png BLOB NOT NULL) STRICT",
    "CREATE TABLE state(id INTEGER PRIMARY KEY, node INTEGER NOT NULL, seal BLOB NOT NULL, "
    "row_hash BLOB NOT NULL) STRICT",
};

constexpr std::size_t mostLooked = 1'000;

} // namespace

std::span<const char* const> tableStatements()
{
    return tables;
}

std::string tableName(std::string_view statement)
{
    statement.remove_prefix(std::string_view("CREATE TABLE ").size());
    return std::string(statement.substr(0, statement.find('(')));
}

bool tablesFitOnePage(std::string_view page, std::size_t mostOthers)
{
    constexpr char leafOfATable = 0x0D;
    const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(page[i])); };
    return page.size() >= 5 && page[0] == leafOfATable &&
           (byte(3) << 8 | byte(4)) <= std::size(tables) + mostOthers;
}

Message foreignTables(const QString& path)
{
    return {QT_TRANSLATE_NOOP("Message", "the tables of \"%1\" are not those of a Bolster project"),
            {path.toStdString()}};
}

void createTables(Database& database)
{
    for (const char* table : tables)
        database.run(table);
    database.run("PRAGMA application_id = 0x426C7374");
    database.run("PRAGMA user_version = 1");
}

void checkTables(Database& database)
{
    std::vector<std::string> wanted(std::begin(tables), std::end(tables));
    std::vector<std::string> found;
    Query query(database, "SELECT sql FROM sqlite_schema");
    while (found.size() <= wanted.size() && query.next())
        found.push_back(query.value(0).type == Value::Type::Text ? std::string(query.text(0)) : std::string());
    std::sort(wanted.begin(), wanted.end());
    std::sort(found.begin(), found.end());
    if (found != wanted)
        throw DatabaseError(foreignTables(database.name()));
}

std::set<std::string> tablesAsTheyShouldBe(Database& database)
{
    std::set<std::string> found;
    Query query(database, "SELECT sql FROM sqlite_schema");
    for (std::size_t looked = 0; looked < mostLooked && query.next(); ++looked) {
        const std::string sql = query.value(0).type == Value::Type::Text ? std::string(query.text(0)) : "";
        if (std::find(std::begin(tables), std::end(tables), sql) != std::end(tables))
            found.insert(tableName(sql));
    }
    return found;
}

} // namespace bolster
