// A sheet cut in two along a line. Private to the library.
#pragma once

#include "Fiedler.h"

namespace bolster {

/// With at least so many triangles, if those inside are enough for that: borders stay as their neighbours have
/// them.
FormSheet fine(FormSheet sheet, std::size_t triangles);

/// Degrees: a line goes along edges that bend by more.
inline constexpr double sharpBend = 15;

/// Along where the halves' numbers change sign: along edges that bend, else smoothly across triangles. Its border
/// gets no new points. One part is empty where the numbers have one sign.
std::array<FormSheet, 2> cutInTwo(FormSheet sheet, const Halves& halves, double bend = sharpBend);

} // namespace bolster
