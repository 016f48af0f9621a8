// Fabrics that come with the program, to begin from.
#pragma once

#include "Fabric.h"

#include <vector>

namespace bolster {

/// With names in the user's language. Kind and colour set each apart; stretch limits are those usual for the kind.
std::vector<Fabric> fabricPresets();

} // namespace bolster
