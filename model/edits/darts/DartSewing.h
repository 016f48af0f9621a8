// What is sewn, held and marked along an edge in which a dart is cut or closed. Private to the library.
#pragma once

#include "DartEdits.h"
#include "EditBuilder.h"

namespace bolster::edits {

/// A seam over the mouth becomes two in the builder; its other side is shared out between them by their lengths.
/// Gives the seams that have been divided so. `mouth`: unwrapped, of the outline before.
std::set<ElementId> divideSeams(const Design& design, const DartShape& mouth, EditBuilder& builder);
/// A notch that lies under the mouth moves to the nearer end of it, in the builder, unless there is one already.
/// Gives those that have moved.
std::set<ElementId> keepNotches(const Design& design, const DartShape& mouth, EditBuilder& builder);
/// Of what is held on a curve, the two parts beside a mouth meet there when the dart is sewn: the gap that the
/// mouth has left on the curve is shared out between them by their lengths.
void closeHeldGap(const DartShape& mouth, EditBuilder& builder);

/// What ends on one side of the mouth and goes on alike on the other one is one again: seams, what is held, trims
/// and allowances of edges. The builder has the outline without the dart already. Gives what has been joined.
std::set<ElementId> joinOverMouth(const Design& design, const DartShape& dart, EditBuilder& builder);

} // namespace bolster::edits
