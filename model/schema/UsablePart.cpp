// What remains of a design without its bad elements.
#include "DesignCheck.h"
#include "References.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bolster {

namespace {

bool affectsSettings(const Problem& problem)
{
    return problem.element == settingsId && problem.severity == Severity::Error && problem.field == "edge_length";
}

/// An element of the right kind.
bool isThere(const Design& design, const Reference& reference)
{
    const ElementPtr element = design.element(reference.id);
    return element && element->index() == reference.kind;
}

// The first element that this one needs and the design does not have.
std::optional<ElementId> missingReference(const Design& design, const Element& element)
{
    for (const Reference& reference : references(element))
        if (isNeeded(reference) && !isThere(design, reference))
            return reference.id;
    return std::nullopt;
}

/// Looks must not cost the shape: what is wrong with them alone gives way to the usual. Null when there is more.
ElementPtr withUsualLooks(const Element& element, const std::vector<std::string>& wrongFields)
{
    const auto onlyIn = [&](std::initializer_list<std::string_view> parts) {
        return std::ranges::all_of(wrongFields, [&](const std::string& field) {
            return std::ranges::any_of(parts, [&](std::string_view part) { return field.starts_with(part); });
        });
    };
    if (seamTrim(element) && onlyIn({"trim."}))
        return withTrim(element, {});
    if (const auto* fabric = std::get_if<Fabric>(&element); fabric && onlyIn({"color", "look.", "limits."})) {
        Fabric usual;
        usual.name = fabric->name;
        usual.poisson = fabric->poisson;
        usual.stiffness = fabric->stiffness;
        usual.bendingLength = fabric->bendingLength;
        return makeElement(std::move(usual));
    }
    return nullptr;
}

/// Without entries that name nothing, or a patch for the second time.
Colourway usableEntries(const Design& design, Colourway colourway)
{
    std::set<ElementId> known;
    std::erase_if(colourway.fabrics, [&](const Colourway::Entry& entry) {
        return !design.find<Patch>(entry.patch) || !design.find<Fabric>(entry.fabric) ||
               !known.insert(entry.patch).second;
    });
    return colourway;
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

    std::map<ElementId, std::vector<std::string>> bad; // the fields
    for (const Problem& problem : problems)
        if (problem.severity == Severity::Error)
            bad[problem.element].push_back(problem.field);
    for (const auto& [id, element] : design.elements()) {
        if (std::holds_alternative<Colourway>(*element))
            continue; // its usable part follows from what it names
        ElementPtr mended = bad.contains(id) ? withUsualLooks(*element, bad[id]) : nullptr;
        if (mended) {
            leave(id, {QT_TRANSLATE_NOOP("Message", "shown in the usual way instead")});
            edit.changes.back().after = std::move(mended);
        } else if (bad.contains(id) && std::holds_alternative<Fabric>(*element)) {
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

    edit.changes.clear();
    usable.each<Colourway>([&](ElementId id, const Colourway& colourway) {
        Colourway rest = usableEntries(usable, colourway);
        if (rest == colourway)
            return;
        leave(id, {QT_TRANSLATE_NOOP("Message", "what it says of missing patches and fabrics is left out")});
        edit.changes.back().after = makeElement(std::move(rest));
    });
    usable = usable.with(edit);

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
