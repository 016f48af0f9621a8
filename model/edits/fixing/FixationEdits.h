// Fixing stretches of outlines to curves in space (paper, section 3.1).
#pragma once

#include "Design.h"
#include "SurfaceMesh.h"

#include <span>

namespace bolster::edits {

/// Why this stretch cannot be fixed, if something is in the way: it has no length, or it overlaps a stretch that is
/// fixed already. What is fixed from end to end just so can be fixed anew.
std::optional<Message> fixationProblem(const Design& design, const Stretch& stretch);

/// Adds a curve that lies where the stretch is on the surface, and fixes the stretch to it: the surface stays as it
/// is. The curve is a cubic within 0.2 mm with the parameters of the outline. It comes first among the changes, the
/// fixation seam after it. Empty when the surface lacks the patch or the stretch has a problem.
Edit addFixationFromSurface(const Design& design, const SurfaceMesh& surface, const Stretch& stretch,
                            const std::string& name);

/// Fixes a stretch to a curve: to all of it, or of a closed one to the part that is nearest. The present surface
/// tells in which direction, or a corner that is held already; without either both run the same way. A fixation of
/// the same stretch is changed. Empty when there is no such curve, the stretch has a problem, or nothing changes.
Edit attachStretch(const Design& design, const Stretch& stretch, ElementId curve, const SurfaceMesh* surface);
/// Fixes several stretches to one curve in a row, in the order in which they lie along it: each gets a part of the
/// curve that is as long as it is, in proportion. On a closed curve the row begins at a corner if one is near.
Edit attachStretches(const Design& design, std::span<const Stretch> stretches, ElementId curve,
                     const SurfaceMesh* surface);
/// Fixes one stretch to several curves in a row: it is divided in proportion to their lengths.
Edit attachToCurves(const Design& design, const Stretch& stretch, std::span<const ElementId> curves,
                    const SurfaceMesh* surface);

} // namespace bolster::edits
