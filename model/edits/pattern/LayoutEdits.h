// Where patches lie in the layout. The surface does not change.
#pragma once

#include "Design.h"

#include <span>

namespace bolster::edits {

/// The box around a patch in the layout, mm; empty without an outline.
Box2 layoutBox(const Patch& patch);
/// Around all of them.
Box2 layoutBox(const Design& design, std::span<const ElementId> patches);

enum class Alignment { Left, Right, Top, Bottom, CentreX, CentreY };

/// Moves patches so that these edges or centres of their boxes lie where that of the box around all is. Top is +y.
Edit alignPatches(const Design& design, std::span<const ElementId> patches, Alignment alignment);

enum class Direction { Horizontal, Vertical };

/// Moves all but the two outermost patches so that the gaps between their boxes are equal (negative where they
/// overlap). Empty for fewer than three.
Edit distributePatches(const Design& design, std::span<const ElementId> patches, Direction direction);

/// Lays patches out in rows without overlap, the tallest first, their boxes `gap` mm apart; the upper left corner
/// of the box around all stays. None: all patches. Rotations stay.
Edit arrangePatches(const Design& design, std::span<const ElementId> patches, double gap = 40);

} // namespace bolster::edits
