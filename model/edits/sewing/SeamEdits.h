// Editing rules for seams. Pure: Design in, Edit out; an empty edit when nothing would change or the wish is
// refused. `problem`, if given, then says why.
#pragma once

#include "Design.h"

#include <span>

namespace bolster::edits {

/// Sews two stretches together. Refused are stretches without length, with a part in common, or with a part that is
/// sewn already.
Edit addSeam(const Design& design, const Stretch& a, const Stretch& b, bool reversed, Message* problem = nullptr);
/// Sews one stretch to others in a row, with a seam each (seamsInRow).
Edit sewInRow(const Design& design, const Stretch& whole, std::span<const Stretch> row, bool flipped,
              Message* problem = nullptr);

/// Sews the seams the other way round: the start of one side to the other end of the other.
Edit flipSeams(const Design& design, std::span<const ElementId> seams);
/// The first side becomes the second; the cover stays the same.
Edit swapSeamSides(const Design& design, std::span<const ElementId> seams);
Edit setContinuity(const Design& design, std::span<const ElementId> seams, Continuity continuity);
Edit setMatch(const Design& design, std::span<const ElementId> seams, Match match);

enum class SeamSide { A, B };
enum class StretchEnd { From, To };
/// Moves an end of the stretch of a seam, fixation seam or trim (whose only side is A) along its outline,
/// unchecked, as a drag does: brokenBy() says what is wrong with the result. An end on the other end makes the
/// stretch the whole outline.
Edit dragStretchEnd(const Design& design, ElementId owner, SeamSide side, StretchEnd end, double parameter);

} // namespace bolster::edits
