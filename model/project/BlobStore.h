// The files that a design uses, by content. Private to the library.
#pragma once

#include "SealedRows.h"

#include <QIODevice>

namespace bolster {

/// Adds the content, unless it is there already. Returns its number.
std::int64_t addBlob(Database& database, SealedRows& rows, QIODevice& source);
/// Writes a content to the device, or only checks it without one. Throws when it is not whole.
void readBlob(Database& database, std::int64_t blob, QIODevice* target);

void removeBlob(Database& database, SealedRows& rows, std::int64_t blob);

/// "frames/chair.obj", "./chair.obj" and so on: a name below a folder, not beside or above.
bool isAssetName(const std::string& name);

} // namespace bolster
