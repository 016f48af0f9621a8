// Darts: a wedge that is taken out of a patch at its outline; its legs are sewn to each other.
#pragma once

#include "Design.h"

namespace bolster::edits {

/// The part of the outline that is taken out, and where the legs meet.
struct DartShape {
    ElementId patch{};
    double from = 0; ///< parameters of the mouth's ends; it is the shorter way between them
    double to = 0;
    Vec2 tip = Vec2::Zero(); ///< inside, outline coordinates, mm
};

/// Cuts a dart: two straight legs take the place of the mouth, with a seam between them that is smooth. All other
/// parameters of the outline keep their meaning. A seam over the mouth is divided, and its other side shared out
/// between the two parts by their lengths, so that the edges meet when the dart is sewn. Refused, with the reason
/// in `problem`, where the legs would leave the patch, or the mouth is a whole edge.
Edit addDart(const Design& design, const DartShape& shape, Message* problem = nullptr);

/// The dart whose legs a seam joins: both are straight, on one patch, and have the tip in common.
std::optional<DartShape> dartOf(const Design& design, ElementId seam);

/// Takes the dart away again: a straight line closes its mouth.
Edit removeDart(const Design& design, ElementId seam, Message* problem = nullptr);
/// The same dart elsewhere on the outline, as far from its tip: `at` is where the middle of its mouth shall be.
Edit moveDart(const Design& design, ElementId seam, double at, Message* problem = nullptr);

} // namespace bolster::edits
