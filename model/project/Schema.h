// The tables of a project file, version 1. Private to the library; docs/project-file.md says what they hold.
#pragma once

#include "Database.h"

namespace bolster {

inline constexpr std::int64_t applicationId = 0x426C7374; // "Blst"
inline constexpr std::int64_t schemaVersion = 1;
inline constexpr std::int64_t pageSize = 8192;

/// In an empty database.
void createTables(Database& database);
/// Throws DatabaseError when the tables are not exactly ours: no others, no views, triggers or indexes.
void checkTables(Database& database);

} // namespace bolster
