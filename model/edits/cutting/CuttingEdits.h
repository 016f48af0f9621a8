// Editing rules for what a cutter needs: seam allowances, corners of the cut line, notches, drill holes, lines
// inside. Pure: Design in, Edit out; an empty edit when nothing would change or the wish is refused. `problem`, if
// given, then says why.
#pragma once

#include "Design.h"

#include <span>

namespace bolster::edits {

/// The patches' own allowance; nothing: the design's.
Edit setAllowance(const Design& design, std::span<const ElementId> patches,
                  const std::optional<CutAllowance>& allowance);
/// Of exactly this stretch, or a new one. Refused where a part of it has an allowance of its own.
Edit setEdgeAllowance(const Design& design, const Stretch& stretch, double width, Message* problem = nullptr);
/// At this corner; one that is there already changes.
Edit setCutCorner(const Design& design, const OutlinePlace& place, CornerJoin join, Message* problem = nullptr);
/// Under the id design.nextId(). Refused where there is one.
Edit addNotch(const Design& design, const OutlinePlace& place, const NotchShape& shape, Message* problem = nullptr);
/// Moves a notch, or the join of a corner, along its outline, unchecked.
Edit movePlace(const Design& design, ElementId mark, double at);
/// Puts notches so far (mm) from the corner that each is nearest to, along the outline and on the same side of it.
/// Refused where the edge is shorter, or has no corner.
Edit setCornerDistance(const Design& design, std::span<const ElementId> notches, double length,
                       Message* problem = nullptr);
/// Under the id design.nextId(). Refused outside of the patch.
Edit addDrillHole(const Design& design, const PatchPoint& point, const std::string& name,
                  Message* problem = nullptr);
/// Moves drill holes by the same vector in outline coordinates, unchecked.
Edit moveDrillHoles(const Design& design, std::span<const ElementId> holes, const Vec2& delta);
Edit addInternalLine(const Design& design, ElementId patch, BSpline2 curve, InternalLine::Purpose purpose,
                     const std::string& name);
/// Where the label of a piece stands; nothing: where it finds room.
Edit setLabel(const Design& design, ElementId patch, const std::optional<PieceLabelPlace>& label);

/// What keeps a mark from being where it is beside the others of its kind.
std::optional<Message> markProblem(const Design& design, ElementId id, const Element& mark);

} // namespace bolster::edits
