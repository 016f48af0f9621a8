// Seams and fixations on twins, and what is drawn in them. Private to the library.
#pragma once

#include "Design.h"

namespace bolster::edits {

/// An edit that gives an outline other knots also says where its stretches are then. The twin's outline gets the
/// same knots, so stretches on it that the edit left alone go where those with the same parameters went.
Design withTwinSeams(const Design& before, const Design& now);

/// What is sewn or fixed anew on twins, changed or removed there is so on the other side, too, unless its
/// stretches are released. Where that cannot be, because something else is there, the other side stays as it is.
Design withTwinSewing(const Design& before, const Design& now);

/// Handle curves and fancy seams that are new in a twin get twins; when one is removed, so is its twin, unless the
/// patch goes with it.
Design withTwinDrawings(const Design& before, const Design& now);

} // namespace bolster::edits
