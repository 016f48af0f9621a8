// Stitches and piping along seams, fancy seams, fixed stretches and free outlines.
#pragma once

#include "Design.h"

#include <span>

namespace bolster::edits {

/// Gives elements a trim; those of kinds without one stay as they are.
Edit setTrim(const Design& design, std::span<const ElementId> elements, const SeamTrim& trim);

/// Why a stretch cannot have a trim of its own: it has no length, is sewn, or has one already. `except` is an
/// outline trim that does not count.
std::optional<Message> trimProblem(const Design& design, const Stretch& stretch, ElementId except = noElement);

/// Adds an OutlineTrim under the id design.nextId(). Empty when it cannot be, with the reason in `problem`.
Edit addOutlineTrim(const Design& design, const Stretch& stretch, const SeamTrim& trim, Message* problem = nullptr);

} // namespace bolster::edits
