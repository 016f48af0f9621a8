// Editing rules for mirror twins: patches, fixation curves, handle curves and fancy seams that follow each other.
#pragma once

#include "Design.h"

#include <functional>
#include <span>

namespace bolster::edits {

/// The edit with what it means for twins: whichever of two was edited, the other follows.
///
/// Points that moved take their twins to the mirrored place, unless they are released; those stay where they are,
/// except when all points of a curve move. Where points were inserted or removed, or a curve was replaced, the
/// other one gets the same points; released ones keep their place. Values that a mirror keeps (fabric, grain,
/// pressure ...) are taken over, names and places in the layout are not. When an edit changes both in different
/// ways, the original wins. The removal of one unlinks the other; of a copy of a twin the link is dropped.
///
/// Seams and fixations have no links: of two that lie where the mirror shows the other one, on twins or on a patch
/// that is its own mirror image, each follows the other, unless all points on their stretches are released. What is
/// sewn, fixed or drawn on a twin comes to be on the other one, too, if nothing is in the way there; what is taken
/// off goes there, too.
///
/// Applied twice it is the same as applied once. withFollowers applies it to every edit.
Edit withTwins(const Design& before, Edit edit);

using MirroredName = std::function<std::string(const std::string&)>;

/// Adds the mirrored copies of patches, fixation curves, handle curves and fancy seams as their twins. Those of a
/// patch bring along what belongs to it: curves drawn in it, fixation seams with twins of their curves, and seams
/// to patches that have twins, to the patch itself, or to the free mirrored stretch of a patch that is its own
/// mirror image. They lie mirrored at the design's axis, or beside the pattern where that is taken. A design
/// without a symmetry gets the default one. What has a twin is passed over.
Edit makeTwins(const Design& design, std::span<const ElementId> ids, const MirroredName& mirroredName);

/// Makes `follower` the twin of `original`: it becomes its exact mirror image and stays where it is in the layout
/// or in space as well as possible; its seams stay on the same places of it. Empty when they are of different
/// kinds, have twins, or, with `problem`, differ by more than a twentieth of their size.
Edit linkTwins(const Design& design, ElementId original, ElementId follower, Message* problem = nullptr);
/// The elements and their twins stay as they are, but follow each other no longer.
Edit unlinkTwins(const Design& design, std::span<const ElementId> ids);

/// The points of both twins go their own ways from now on. Points are numbered as in Twin.
Edit releasePoints(const Design& design, ElementId id, std::span<const int> points);
/// Released points of this element jump to the mirror image of its twin's, and follow again.
Edit relinkPoints(const Design& design, ElementId id, std::span<const int> points);

/// The twin; of a seam or fixation the one where the mirror shows it; noElement when there is none.
ElementId mirroredElement(const Design& design, ElementId id);
/// Those of several; without these themselves.
std::set<ElementId> mirroredElements(const Design& design, const std::set<ElementId>& ids);
/// Whether a seam or fixation goes its own ways, because all points on its stretches do.
bool sewingReleased(const Design& design, ElementId id);
/// Makes a seam or fixation the mirror image of the one that lies there, at least for a part.
Edit relinkSewing(const Design& design, ElementId id);

/// The control points with most influence on a stretch, its ends included; never none.
std::vector<int> pointsOnStretch(const BSpline2& outline, double from, double to);

} // namespace bolster::edits
