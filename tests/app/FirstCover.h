// The path of a newcomer: from the start page to a sewn cushion. The pictures of docs/first-cover.md are made on
// it.
#pragma once

#include "Designer.h"

#include <functional>

namespace bolster {

/// Called where a picture is worth while, with its name.
using Stop = std::function<void(const QString& name)>;

/// In a window that has just been opened.
void sewFirstCover(Designer& designer, const Stop& stop);

} // namespace bolster
