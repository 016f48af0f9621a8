// Lines that end inside a piece, and where they can go on. Private to the library.
#pragma once

#include "LineEnds.h"

namespace bolster {

/// One of the lines ends at a place of the form.
OpenEnd openEndAt(const Vec3& at, const UncutForm& form, const std::vector<LineToCut>& lines);

} // namespace bolster
