// What remains of a design without its bad elements.
#include "DesignCheck.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

bool affectsSettings(const Problem& problem)
{
    return problem.element == settingsId && problem.severity == Severity::Error && problem.field == "edge_length";
}

// The first element that this one needs and the design does not have.
std::optional<ElementId> missingReference(const Design& design, const Element& element)
{
    if (const auto* patch = std::get_if<Patch>(&element); patch && !design.find<Fabric>(patch->fabric))
        return patch->fabric;
    if (const auto* seam = std::get_if<Seam>(&element)) {
        for (const Stretch& stretch : {seam->a, seam->b})
            if (!design.find<Patch>(stretch.patch))
                return stretch.patch;
    }
    if (const auto* fixation = std::get_if<FixationSeam>(&element)) {
        if (!design.find<Patch>(fixation->stretch.patch))
            return fixation->stretch.patch;
        if (fixation->hasCurve() && !design.find<FixationCurve>(fixation->curve))
            return fixation->curve;
    }
    if (const PatchCurve* drawn = patchCurve(element); drawn && !design.find<Patch>(drawn->patch))
        return drawn->patch;
    if (const auto* cushion = std::get_if<Cushion>(&element)) {
        if (!design.find<Frame>(cushion->frame))
            return cushion->frame;
        for (const ElementId patch : cushion->patches)
            if (!design.find<Patch>(patch))
                return patch;
    }
    if (const auto* foam = std::get_if<Foam>(&element); foam && !design.find<Cushion>(foam->cushion))
        return foam->cushion;
    return std::nullopt;
}

} // namespace

Design usablePart(const Design& design, const Problems& problems, Problems* leftOut)
{
    Problems reported;
    Edit edit;
    const auto leave = [&](ElementId id, Message why) {
        const ElementPtr element = design.element(id);
        reported.push_back({id, elementLabel(id, *element), "", std::move(why), Severity::Warning});
        edit.changes.push_back({id, element, nullptr});
    };

    std::set<ElementId> bad;
    for (const Problem& problem : problems)
        if (problem.severity == Severity::Error)
            bad.insert(problem.element);
    for (const auto& [id, element] : design.elements()) {
        if (bad.contains(id) && std::holds_alternative<Fabric>(*element)) {
            // Without it all its patches would be lost for one wrong number.
            leave(id, {QT_TRANSLATE_NOOP("Message", "the usual values of a fabric are used instead")});
            edit.changes.back().after = makeElement(Fabric{});
        } else if (bad.contains(id) || std::holds_alternative<Quarantined>(*element)) {
            leave(id, {QT_TRANSLATE_NOOP("Message", "left out because of its errors")});
        }
    }
    Design usable = design.with(edit);

    for (bool settled = false; !settled;) { // a patch without its fabric takes its seams with it
        settled = true;
        edit.changes.clear();
        for (const auto& [id, element] : usable.elements()) {
            const std::optional<ElementId> missing = missingReference(usable, *element);
            if (!missing)
                continue;
            const ElementPtr needed = design.element(*missing);
            leave(id, {QT_TRANSLATE_NOOP("Message", "left out because it needs %1, which is not there"),
                       {needed ? elementLabel(*missing, *needed) : elementLabel("", *missing, "")}});
            settled = false;
        }
        usable = usable.with(edit);
    }

    if (std::any_of(problems.begin(), problems.end(), affectsSettings)) {
        // Twelve millimetres, unless that makes too many triangles of the patches that are left.
        Settings settings;
        settings.edgeLength = std::max(settings.edgeLength, std::ceil(smallestEdgeLength(usable)));
        usable = usable.with({{}, {{settingsId, nullptr, makeElement(settings)}}});
        reported.push_back({settingsId,
                            "settings",
                            "edge_length",
                            {QT_TRANSLATE_NOOP("Message", "an edge length of %1 mm is used instead"),
                             {numberText(settings.edgeLength)}},
                            Severity::Warning});
    }
    if (leftOut) {
        std::stable_sort(reported.begin(), reported.end(),
                         [](const Problem& a, const Problem& b) { return a.element < b.element; });
        *leftOut = std::move(reported);
    }
    return usable;
}

} // namespace bolster
