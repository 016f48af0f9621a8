// Project files as a whole. Private to the library.
#pragma once

#include "Project.h"
#include "SealedRows.h"

#include <functional>

namespace bolster {

/// Lets `write` fill an empty file beside `path`, checks it with all its assets, and moves it into the place of
/// `path`: that holds the old bytes or the new ones at any moment. Returns the seal of the file. Throws
/// DatabaseError.
Hash replaceProject(const QString& path, const std::function<void(const QString& file)>& write,
                    ProjectCheck check = ProjectCheck::ToWork);

/// Throws when the content is damaged.
void copyAsset(Database& from, std::int64_t blob, const std::string& name, Database& to, SealedRows& rows);

} // namespace bolster
