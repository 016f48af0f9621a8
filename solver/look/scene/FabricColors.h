// Colours of a fabric that follow from others.
#pragma once

#include "Fabric.h"

namespace bolster {

/// What the other yarn, the creases or the other squares are coloured with, given or derived: "#rrggbb".
std::string secondColorShown(const Fabric& fabric);

} // namespace bolster
