// Selects what lies under the pointer in the pattern view.
#pragma once

#include "PatternScene.h"
#include "Selection.h"

namespace bolster {

/// The edge between two corners at a hit on an outline.
std::optional<Selection::Edge> edgeAt(const PatternScene& scene, const PatternHit& hit);
/// What else a click there may mean: of an outline the hits on all that is sewn or fixed there, then on the patch;
/// in the order in which clicks go through them. Of anything else the hit alone.
std::vector<PatternHit> hitsThere(const PatternScene& scene, const PatternHit& hit);
bool isSelected(const Selection& selection, const PatternScene& scene, const PatternHit& hit);
/// Only this: the control point, the edge with what it belongs to, the line or patch; nothing beside them.
void selectOnly(Selection& selection, const PatternScene& scene, const PatternHit& hit);
/// This, too, or not any more.
void selectToo(Selection& selection, const PatternScene& scene, const PatternHit& hit);

} // namespace bolster
