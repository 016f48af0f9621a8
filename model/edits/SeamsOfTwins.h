// Seams on twins whose outlines got other knots. Private to the library.
#pragma once

#include "Design.h"

namespace bolster::edits {

/// An edit that gives an outline other knots also says where its stretches are then. The twin's outline gets the
/// same knots, so stretches on it that the edit left alone go where those with the same parameters went.
Design withTwinSeams(const Design& before, const Design& now);

} // namespace bolster::edits
