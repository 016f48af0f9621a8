// What an edit takes along.
#pragma once

#include "Design.h"

namespace bolster::edits {

/// The edit with what it takes along: what lies on outlines, and mirror twins (withTwins). Document and Gesture
/// apply it to every edit; applied twice it is the same as applied once.
///
/// A control point of a handle curve or fancy seam, or an end of a measurement, that lies on the outline of its
/// patch keeps its place there when the outline changes: the same parameter, as the ends of seams do. No matter how
/// it came there: it is on the outline, that is all that counts, so nothing has to be stored. Points that the edit
/// itself moves go where it says. The points next to an end that follows come along in part, so that curves keep
/// their shape there. Who cuts, joins or links patches gives their outlines other parameters, and puts in its place
/// what lies on them.
Edit withFollowers(const Design& before, Edit edit);

} // namespace bolster::edits
