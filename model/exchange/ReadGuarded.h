// What the importers of files share: bytes in, refusals made into messages.
#pragma once

#include "Message.h"

#include <QString>

#include <functional>
#include <string_view>

namespace bolster {

/// Reads the file and hands its bytes to `read`, which may throw FileRefused. Returns what went wrong, with file
/// and line or offset, or an empty message.
Message readGuarded(const QString& path, const std::function<void(std::string_view bytes)>& read);

} // namespace bolster
