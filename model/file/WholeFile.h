// Files that are read and replaced as a whole.
#pragma once

#include "Message.h"

#include <QString>

#include <cstdint>
#include <string>
#include <string_view>

namespace bolster {

struct WholeFile {
    std::string bytes;
    Message problem; ///< why it could not be read; empty when it was
};

/// Reads a regular file of at most `largest` bytes.
WholeFile readWholeFile(const QString& path, std::int64_t largest);

/// Writes to a temporary file in the same folder, syncs it, renames it over `path` and syncs the folder: after a
/// power cut `path` holds the old bytes or the new ones, never a mixture. Links are followed and permissions kept;
/// pipes and devices ("/dev/stdout") are written to directly. Returns what went wrong, or an empty message; the old
/// file is untouched then.
Message replaceWholeFile(const QString& path, std::string_view bytes);

/// The name for a temporary file in the folder of `path`; nothing is made.
QString temporaryFileFor(const QString& path);
/// The second half of replaceWholeFile, for a file that something else has written: syncs it, gives it the
/// permissions of the file at `path`, if there is one, renames it over that and syncs the folder. Removes the
/// temporary file if it fails.
Message moveIntoPlace(const QString& temporary, const QString& path);

} // namespace bolster
