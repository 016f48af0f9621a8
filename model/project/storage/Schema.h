// The tables of a project file, version 1. Private to the library; docs/project-file.md says what they hold.
#pragma once

#include "Database.h"

#include <set>
#include <span>
#include <string>

namespace bolster {

inline constexpr std::int64_t applicationId = 0x426C7374; // "Blst"
inline constexpr std::int64_t schemaVersion = 1;
inline constexpr std::int64_t pageSize = 8192;

/// "CREATE TABLE name(...)" of each of them.
std::span<const char* const> tableStatements();
std::string tableName(std::string_view statement);

/// Whether the list of tables, from byte 100 of a file on, is one that ours fit in, with some others. Asked before
/// SQLite reads it, which believes all that is in there, and may need 40 times as much memory.
bool tablesFitOnePage(std::string_view page, std::size_t mostOthers = 0);
Message foreignTables(const QString& path);

/// In an empty database.
void createTables(Database& database);
/// Throws DatabaseError when the tables are not exactly ours: no others, no views, triggers or indexes.
void checkTables(Database& database);
/// Of a damaged file: the names of those that are ours to the letter. The others must not even be asked: a column
/// may be computed, and take for ever.
std::set<std::string> tablesAsTheyShouldBe(Database& database);

} // namespace bolster
