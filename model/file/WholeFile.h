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

/// Copies a regular file of at most `largest` bytes to a new one that only its owner may read. Returns what went
/// wrong, or an empty message.
Message copyWholeFile(const QString& from, const QString& to, std::int64_t largest);

/// Writes to a temporary file in the same folder, syncs it, renames it over `path` and syncs the folder: after a
/// power cut `path` holds the old bytes or the new ones, never a mixture. Links are followed and permissions kept;
/// pipes that somebody reads and devices ("/dev/stdout") are written to directly. Returns what went wrong, or an
/// empty message; the old file is untouched then.
Message replaceWholeFile(const QString& path, std::string_view bytes);

/// Likewise a file that is not there yet: what has come to be there meanwhile stays, and is said to be there.
Message createWholeFile(const QString& path, std::string_view bytes);

/// Where a path leads: links are followed, also to a file that is not there yet.
QString resolved(const QString& path);

/// The same for all names of one file: links to it lead there, and what has two names is told by its number. Of
/// what is not there yet, the place where it will be.
QString fileKey(const QString& path);

} // namespace bolster
