// What is hidden in the 3D view: not a part of the design.
#pragma once

#include "Design.h"

#include <set>

namespace bolster {

/// Which of these elements can be hidden: patches, what is drawn in them, curves, frames, foam, scans.
std::set<ElementId> hideable(const Design& design, const std::set<ElementId>& elements);
/// What has to be hidden so that only these elements are seen, with what is drawn in them and what fixes them.
std::set<ElementId> allBut(const Design& design, const std::set<ElementId>& elements);
/// Whether the element is hidden itself or with its patch.
bool isHidden(const Design& design, const std::set<ElementId>& hidden, ElementId id);

} // namespace bolster
