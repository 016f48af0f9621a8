#include "Hiding.h"

#include "PatchMark.h"

namespace bolster {

namespace {

bool canBeHidden(const Element& element)
{
    return std::holds_alternative<Patch>(element) || std::holds_alternative<Frame>(element) ||
           std::holds_alternative<Foam>(element) || std::holds_alternative<Scan>(element) ||
           std::holds_alternative<FixationCurve>(element) || shapingCurve(element);
}

} // namespace

std::set<ElementId> hideable(const Design& design, const std::set<ElementId>& elements)
{
    std::set<ElementId> result;
    for (const ElementId id : elements)
        if (const ElementPtr element = design.element(id); element && canBeHidden(*element))
            result.insert(id);
    return result;
}

std::set<ElementId> allBut(const Design& design, const std::set<ElementId>& elements)
{
    std::set<ElementId> kept = hideable(design, elements);
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        if (elements.contains(id))
            kept.insert({seam.a.patch, seam.b.patch});
    });
    design.each<FixationSeam>([&](ElementId id, const FixationSeam& seam) {
        if (elements.contains(id))
            kept.insert(seam.stretch.patch);
        if (kept.contains(seam.stretch.patch))
            kept.insert(seam.curve);
    });
    eachMarkKind([&]<class T>() {
        design.each<T>([&](ElementId id, const T& mark) {
            if (elements.contains(id))
                kept.insert(whereOf(mark).patch);
        });
    });
    std::set<ElementId> hidden;
    for (const auto& [id, element] : design.elements()) {
        const PatchCurve* drawn = patchCurve(*element);
        if (canBeHidden(*element) && !kept.contains(id) && !(drawn && kept.contains(drawn->patch)))
            hidden.insert(id);
    }
    return hidden;
}

bool isHidden(const Design& design, const std::set<ElementId>& hidden, ElementId id)
{
    if (hidden.empty())
        return false;
    const ElementPtr element = design.element(id);
    const PatchCurve* drawn = element ? patchCurve(*element) : nullptr;
    return hidden.contains(id) || (drawn && hidden.contains(drawn->patch));
}

} // namespace bolster
