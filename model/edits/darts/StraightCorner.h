// Corners that are none. Private to the library.
#pragma once

#include "EditBuilder.h"

namespace bolster::edits {

/// Takes a corner out of a polygon where it does not bend, unless something begins or ends beside it on its edges,
/// whose place would be another one then.
void dropStraightCorner(ElementId patch, double corner, EditBuilder& builder);

} // namespace bolster::edits
