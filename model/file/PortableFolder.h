// A Bolster that is carried about, on a stick for instance: what it keeps lies beside it.
#pragma once

#include "Message.h"

#include <QString>

#include <filesystem>

namespace bolster {

/// "bolster-settings" beside the program that lies in `program`, or beside its folder "bin"; "" unless there is a
/// file "portable" in one of the two, or `asked`.
QString portableFolder(const std::filesystem::path& program, bool asked);

/// From now on settings, work in progress and the caches of libraries are kept in this folder, which is made, and
/// nothing in the user's home. To be called before anything reads a setting, and before there is a second thread.
/// Why it cannot be, or nothing.
Message keepEverythingIn(const QString& folder);

} // namespace bolster
