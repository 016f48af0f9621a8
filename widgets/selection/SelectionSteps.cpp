#include "SelectionSteps.h"

#include "Selection.h"
#include "SelectionEdits.h"

#include <algorithm>

namespace bolster {

namespace {

bool selectNextPoint(const Design& design, Selection& selection, bool forward)
{
    const Selection::Points& points = selection.points();
    const Selection::Point from = forward ? *points.rbegin() : *points.begin();
    const ElementPtr element = design.element(from.first);
    if (!element)
        return false;
    const BSpline2* plane = planeCurve(*element);
    const BSpline3* space = spaceCurve(*element);
    const bool inSpace = spacePoint(design, from) >= 0;
    const int count = inSpace ? space->pointCount() : plane ? plane->pointCount() : 0;
    if (count == 0)
        return false;
    const int first = inSpace ? selectionPoint(*element, 0) : 0;
    const int next = (from.second - first + (forward ? 1 : count - 1)) % count;
    selection.set({from.first}, {{from.first, first + next}});
    return true;
}

} // namespace

bool selectNext(const Design& design, Selection& selection, bool forward)
{
    if (!selection.points().empty())
        return selectNextPoint(design, selection, forward);
    std::vector<ElementId> patches;
    design.each<Patch>([&](ElementId id, const Patch&) { patches.push_back(id); });
    if (patches.empty())
        return false;
    const std::vector<ElementId> selected = selectedOf<Patch>(design, selection.elements());
    const auto count = static_cast<std::ptrdiff_t>(patches.size());
    std::ptrdiff_t next = forward ? 0 : count - 1;
    if (!selected.empty()) {
        const ElementId from = forward ? selected.back() : selected.front();
        const std::ptrdiff_t place = std::ranges::find(patches, from) - patches.begin();
        next = (place + (forward ? 1 : count - 1)) % count;
    }
    selection.set({patches[static_cast<std::size_t>(next)]});
    return true;
}

} // namespace bolster
