// What the importers of files share: bytes in, refusals made into messages.
#pragma once

#include "FileBytes.h"
#include "Message.h"

#include <QString>

namespace bolster {

/// Opens the file and hands its bytes to `read`, which may throw FileRefused. Returns what went wrong, with file
/// and line or offset, or an empty message. When the watch stops it, too: whoever stopped it knows.
Message readGuarded(const QString& path, std::int64_t largest, const ImportWatch& watch,
                    const std::function<void(const FileBytes& bytes)>& read);

/// The same watch, which keeps the last thing that is odd in `odd`.
ImportWatch warning(ImportWatch watch, const QString& path, Message& odd);

} // namespace bolster
