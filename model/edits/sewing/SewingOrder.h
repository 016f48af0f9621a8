// In which order the seams are sewn: as the designer numbered them (Seam::step), or as is proposed.
#pragma once

#include "Design.h"

#include <span>

namespace bolster {

struct SewingStep {
    ElementId seam{};
    bool closes = false; ///< everything that it joins hangs together before it
};

/// All seams between patches that are there. Those with a number come first, by it. The others are proposed, one
/// cover (what hangs together in the end) after the other: darts, while their pieces are flat; then always the seam
/// that joins the two parts of the cover with the fewest pieces, shorter ones before longer ones, so that large
/// parts are handled late. A seam that closes a ring is sewn as soon as its two sides hang together, before more is
/// sewn to them; those that close the cover come last.
std::vector<SewingStep> sewingOrder(const Design& design);

namespace edits {

enum class SewingMove { Earlier, Later };

/// Sews these seams one step earlier or later, in the order that they have among themselves; from then on the order
/// is the designer's, and all seams have their numbers. Empty when they stand at that end already.
Edit moveInSewingOrder(const Design& design, std::span<const ElementId> seams, SewingMove move);

/// Back to the order that is proposed.
Edit proposeSewingOrder(const Design& design);

} // namespace edits

} // namespace bolster
