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

/// The mouth between two places in the order in which the outline runs, the shorter way; no tip yet.
DartShape dartBetween(const Design& design, ElementId patch, double a, double b);
/// The other end of a mouth of this width (mm, straight across) that begins at `from`; nothing where the outline
/// has no room for it.
std::optional<double> mouthEnd(const BSpline2& outline, double from, double width, bool ahead);

/// Where the tip has to lie for both legs to be equally long: from the middle of the mouth at right angles inwards.
struct DartAxis {
    Vec2 middle = Vec2::Zero();
    Vec2 inwards = Vec2::Zero(); ///< of length 1
    double width = 0;            ///< of the mouth, straight across, mm
};
DartAxis dartAxis(const BSpline2& outline, const DartShape& dart);

/// Cuts a dart: two straight legs take the place of the mouth, with a seam between them that is smooth. All other
/// parameters of the outline keep their meaning. A seam over the mouth is divided, and its other side shared out
/// between the two parts by their lengths, so that the edges meet when the dart is sewn; of one that reaches into
/// the mouth the other side stays whole. What is held on a curve is divided likewise. Notches that lie under the
/// mouth move to its nearer end. Refused, with the reason in `problem`, where the legs would leave the patch, or
/// the mouth is a whole edge. The twin of the patch, if it has one, gets the mirror image; so it is with all that
/// follows.
Edit addDart(const Design& design, const DartShape& shape, Message* problem = nullptr);

/// The dart whose legs a seam joins: both are straight, on one patch, and have the tip in common.
std::optional<DartShape> dartOf(const Design& design, ElementId seam);

/// The dart of the twin that lies at the same parameters; noElement when there is none.
ElementId twinDart(const Design& design, const DartShape& dart);

/// The edge goes on as if the dart had never been cut; where it was turned open, smoothly. What it has divided of a
/// seam is one again.
Edit removeDart(const Design& design, ElementId seam, Message* problem = nullptr);
/// Puts the tip elsewhere; the mouth stays, and what lies on the legs keeps its share of them.
Edit moveDartTip(const Design& design, ElementId seam, const Vec2& tip, Message* problem = nullptr);
/// The same dart elsewhere on the outline, as far from its tip: `at` is where the middle of its mouth shall be.
Edit moveDart(const Design& design, ElementId seam, double at, Message* problem = nullptr);

} // namespace bolster::edits
