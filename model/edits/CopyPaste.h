// Patches and fixation curves as text for the clipboard, and back; duplicates.
#pragma once

#include "EditOutcome.h"

#include <span>
#include <string>
#include <string_view>

namespace bolster::edits {

/// The selected patches and fixation curves with what belongs to them: fabrics, curves drawn in the patches, seams
/// among them, fixation seams between a patch and a curve that are both selected. Whether there is anything.
bool canCopy(const Design& design, std::span<const ElementId> ids);
/// As a complete design (docs/design-json.md). Empty when there is nothing to copy.
std::string copyText(const Design& design, std::span<const ElementId> ids);

/// Adds what a text of `copyText`, or any other design, has of these kinds, under fresh ids, moved by `offset` in
/// the layout (mm). A fabric that the design has already is used; names that it has get a number. Refused when the
/// text is no design or has nothing of the kind.
Outcome paste(const Design& design, std::string_view text, const Vec2& offset);

/// The same in one step. Empty when there is nothing to copy.
Edit duplicatePatches(const Design& design, std::span<const ElementId> ids, const Vec2& offset);

/// The patches and fixation curves that an edit adds: what to select after it.
std::vector<ElementId> addedPieces(const Edit& edit);

} // namespace bolster::edits
