// How sentences speak of an element.
#pragma once

#include "Design.h"

namespace bolster {

/// Its name, shortened, or its label where it has none; "" of nothing.
std::string spokenName(const Design& design, ElementId id);

} // namespace bolster
