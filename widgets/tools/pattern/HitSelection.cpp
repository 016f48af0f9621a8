#include "HitSelection.h"

#include "StretchToFix.h"

#include <algorithm>

namespace bolster {

std::optional<Selection::Edge> edgeAt(const PatternScene& scene, const PatternHit& hit)
{
    const PatternPatch* patch = hit.kind == PatternHit::Kind::Outline ? scene.patch(hit.patch) : nullptr;
    if (!patch)
        return std::nullopt;
    return Selection::Edge{hit.element(), outlineEdgeAt(hit.patch, patch->patch().outline, hit.parameter)};
}

std::vector<PatternHit> hitsThere(const PatternScene& scene, const PatternHit& hit)
{
    const PatternPatch* patch = hit.kind == PatternHit::Kind::Outline ? scene.patch(hit.patch) : nullptr;
    if (!patch)
        return {hit};
    std::vector<PatternHit> there;
    const auto add = [&](ElementId owner) {
        there.push_back(hit);
        there.back().seam = owner;
    };
    add(noElement);
    for (const auto& [owner, stretch] : scene.stretches())
        if (stretch.patch == hit.patch && there.back().seam != owner &&
            stretch.contains(patch->patch().outline, hit.parameter))
            add(owner);
    std::ranges::reverse(there); // the uppermost is what is hit
    return there;
}

bool isSelected(const Selection& selection, const PatternScene& scene, const PatternHit& hit)
{
    if (hit.kind == PatternHit::Kind::Point)
        return selection.contains(Selection::Point{hit.patch, hit.point});
    if (!hit || !selection.contains(hit.element()) || !selection.points().empty())
        return false;
    // Where edges are selected, they are meant, not all of the patch.
    const auto edge = edgeAt(scene, hit);
    return selection.edges().empty() || !edge || selection.contains(*edge);
}

void selectOnly(Selection& selection, const PatternScene& scene, const PatternHit& hit)
{
    if (hit.kind == PatternHit::Kind::Point)
        selection.set({hit.patch}, {{hit.patch, hit.point}});
    else if (const auto edge = edgeAt(scene, hit))
        selection.set({edge->owner}, {}, {*edge});
    else if (hit)
        selection.set({hit.element()});
    else
        selection.clear();
}

void selectToo(Selection& selection, const PatternScene& scene, const PatternHit& hit)
{
    if (hit.kind == PatternHit::Kind::Point) {
        selection.toggle(Selection::Point{hit.patch, hit.point});
        return;
    }
    if (!hit)
        return;
    const auto edge = edgeAt(scene, hit);
    const bool whole = edge && selection.contains(edge->owner) &&
                       std::ranges::none_of(selection.edges(), [&](const Selection::Edge& other) {
                           return other.owner == edge->owner;
                       });
    if (edge && !whole)
        selection.toggle(*edge);
    else
        selection.toggle(hit.element());
}

} // namespace bolster
