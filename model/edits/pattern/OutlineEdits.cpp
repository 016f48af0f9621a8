#include "OutlineEdits.h"

#include "DesignCheck.h"
#include "EditHelpers.h"
#include "PlaneCurves.h"

namespace bolster::edits {

namespace {

/// That one, or the design's first; nothing when it has none.
std::optional<ElementId> usableFabric(const Design& design, std::optional<ElementId> wanted)
{
    if (wanted && design.find<Fabric>(*wanted))
        return wanted;
    std::optional<ElementId> first;
    design.each<Fabric>([&](ElementId id, const Fabric&) { first = first.value_or(id); });
    return first;
}

} // namespace

Edit addPatch(const Design& design, BSpline2 outline, const std::string& name, std::optional<ElementId> fabric)
{
    if (outlineProblem(outline))
        return {};
    Patch patch;
    patch.name = name;
    patch.position = outline.boundingBox().min();
    const Map2 toCorner(Eigen::Translation2d(-patch.position));
    auto placed = mapped(outline.signedArea() < 0 ? outline.reversed() : outline, toCorner);
    if (!placed)
        return {};
    patch.outline = std::move(*placed);

    Edit edit;
    if (const auto found = usableFabric(design, fabric)) {
        patch.fabric = *found;
    } else {
        Fabric usual;
        usual.name = "Leather";
        edit = addElement(design, makeElement(std::move(usual)));
        patch.fabric = edit.changes.front().id;
    }
    Edit add = addElement(design.with(edit), makeElement(std::move(patch)));
    edit.verb = std::move(add.verb);
    edit.changes.push_back(std::move(add.changes.front()));
    return edit;
}

} // namespace bolster::edits
