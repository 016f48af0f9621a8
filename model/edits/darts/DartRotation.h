// The classic manipulation of darts: one is closed, and the pattern opens elsewhere by the same angle.
#pragma once

#include "Design.h"

namespace bolster::edits {

/// Closes the dart that the seam sews and opens it at `to`, a parameter of the outline: the part of the patch
/// between the dart and the line from its tip to there, the shorter one of the two, is turned about the tip. The
/// area stays, and so does the length of every seam. Seams, fixations, marks, drill holes, drawn curves and the
/// label of the turned part go with it; parameters of the other part keep their meaning. A seam over `to` is
/// divided there. The twin of the patch is opened in the mirror image. Refused, with the reason in `problem`, when
/// the legs are not of one length, when the line leaves the patch or a drawn curve lies across it, or the outline
/// would cross itself.
Edit rotateDart(const Design& design, ElementId seam, double to, Message* problem = nullptr);

} // namespace bolster::edits
