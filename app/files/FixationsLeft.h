// What a frame leaves behind whose file was replaced.
#pragma once

#include "FixationsOff.h"

class QWidget;

namespace bolster {

/// Looks in the background which fixation curves lay on the mesh of before and do not lie on the present one, and
/// says so in a box of `window`; nothing when all still do. Goes away with the window.
void tellFixationsOff(QWidget* window, const Design& design, const PlacedMesh& before, const PlacedMesh& after);

} // namespace bolster
