// Places along lines. Private to the library.
#pragma once

#include "Form.h"

namespace bolster {

/// mm, from the first place to the last one.
double lengthOf(const std::vector<Vec3>& places);

/// Its points, and places between them at most so far apart, mm; the first one again at the end of a closed line.
std::vector<Vec3> evenly(const FormLine& line, double apart);

} // namespace bolster
