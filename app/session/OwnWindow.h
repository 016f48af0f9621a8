// Another window of the program.
#pragma once

#include <QString>

namespace bolster {

/// In a program of its own, portable as this one: whatever happens to one design, the others go on. Empty: with
/// nothing open. Whether it could be started.
bool openInWindowOfItsOwn(const QString& path = {});

} // namespace bolster
