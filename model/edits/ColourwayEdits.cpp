#include "ColourwayEdits.h"

#include "EditBuilder.h"
#include "Twins.h"

#include <algorithm>

namespace bolster::edits {

namespace {

void setEntry(Colourway& colourway, ElementId patch, ElementId fabric)
{
    const auto entry = std::ranges::find(colourway.fabrics, patch, &Colourway::Entry::patch);
    if (fabric == noElement)
        std::erase_if(colourway.fabrics, [patch](const Colourway::Entry& each) { return each.patch == patch; });
    else if (entry == colourway.fabrics.end())
        colourway.fabrics.push_back({patch, fabric});
    else
        entry->fabric = fabric;
}

/// The patches among the ids, each once.
std::vector<ElementId> patchesOf(const Design& design, std::span<const ElementId> ids)
{
    const std::set<ElementId> once(ids.begin(), ids.end());
    std::vector<ElementId> patches;
    std::ranges::copy_if(once, std::back_inserter(patches),
                         [&](ElementId id) { return design.find<Patch>(id) != nullptr; });
    return patches;
}

} // namespace

Edit addFabric(const Design& design, Fabric fabric)
{
    fabric.name = freeName<Fabric>(design, fabric.name);
    return addElement(design, makeElement(std::move(fabric)));
}

std::vector<ElementId> patchesWith(const Design& design, ElementId fabric)
{
    std::set<ElementId> found;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        if (patch.fabric == fabric)
            found.insert(id);
    });
    design.each<Colourway>([&](ElementId, const Colourway& colourway) {
        for (const Colourway::Entry& entry : colourway.fabrics)
            if (entry.fabric == fabric && design.find<Patch>(entry.patch))
                found.insert(entry.patch);
    });
    return {found.begin(), found.end()};
}

Edit removeFabric(const Design& design, ElementId fabric, ElementId instead)
{
    if (!design.find<Fabric>(fabric) || fabric == instead)
        return {};
    const ElementId only[] = {fabric};
    if (!design.find<Fabric>(instead))
        return instead == noElement ? removeElements(design, only) : Edit{};
    EditBuilder builder(design);
    for (const auto& [id, element] : design.elements()) {
        Element changed = *element;
        if (auto* patch = std::get_if<Patch>(&changed); patch && patch->fabric == fabric)
            patch->fabric = instead;
        if (auto* colourway = std::get_if<Colourway>(&changed))
            for (Colourway::Entry& entry : colourway->fabrics)
                if (entry.fabric == fabric)
                    entry.fabric = instead;
        if (const SeamTrim* trim = seamTrim(changed); trim && trim->pipingFabric == fabric) {
            SeamTrim other = *trim;
            other.pipingFabric = instead;
            changed = *withTrim(changed, std::move(other));
        }
        if (!(changed == *element))
            builder.set(id, makeElement(std::move(changed)));
    }
    builder.remove(fabric);
    return builder.result({QT_TRANSLATE_NOOP("Message", "Replace fabric %1 by %2"),
                           {displayName(design, fabric), displayName(design, instead)}});
}

Edit giveFabric(const Design& design, std::span<const ElementId> patches, ElementId fabric)
{
    const ElementId shown = design.settings().colourway;
    return design.find<Colourway>(shown) ? setColourwayFabric(design, shown, patches, fabric)
                                         : assignFabric(design, patches, fabric);
}

Edit assignFabric(const Design& design, std::span<const ElementId> patches, ElementId fabric)
{
    if (!design.find<Fabric>(fabric))
        return {};
    EditBuilder builder(design);
    const std::vector<ElementId> made = patchesOf(design, patches);
    if (made.empty())
        return {};
    for (const ElementId id : made) {
        Patch patch = *design.find<Patch>(id);
        patch.fabric = fabric;
        builder.replace(id, std::move(patch));
    }
    const std::string name = displayName(design, fabric);
    if (made.size() == 1)
        return builder.result(
            {QT_TRANSLATE_NOOP("Message", "Make %1 of %2"), {displayName(design, made.front()), name}});
    return builder.result(
        {QT_TRANSLATE_NOOP("Message", "Make %1 patches of %2"), {std::to_string(made.size()), name}});
}

Edit addColourway(const Design& design, const std::string& name)
{
    EditBuilder builder(design);
    Settings settings = design.settings();
    const auto* shown = design.find<Colourway>(settings.colourway);
    Colourway colourway = shown ? *shown : Colourway{};
    colourway.name = freeName<Colourway>(design, name);
    const Message verb{QT_TRANSLATE_NOOP("Message", "Add colourway %1"), {colourway.name}};
    settings.colourway = builder.add(std::move(colourway));
    builder.replace(settingsId, settings);
    return builder.result(verb);
}

Edit setColourwayFabric(const Design& design, ElementId colourway, std::span<const ElementId> patches,
                        ElementId fabric)
{
    const auto* before = design.find<Colourway>(colourway);
    if (!before || (fabric != noElement && !design.find<Fabric>(fabric)))
        return {};
    Colourway changed = *before;
    const std::vector<ElementId> chosen = patchesOf(design, patches);
    for (const ElementId patch : chosen) {
        setEntry(changed, patch, fabric);
        if (const ElementId twin = twinOf(design, patch); twin != noElement)
            setEntry(changed, twin, fabric);
    }
    return replaceWith(design, colourway, std::move(changed),
                       patchesVerb(design, chosen, QT_TRANSLATE_NOOP("Message", "Change what %1 shows"),
                                   QT_TRANSLATE_NOOP("Message", "Change what %1 patches show")));
}

Edit showColourway(const Design& design, ElementId colourway)
{
    Settings settings = design.settings();
    settings.colourway = colourway;
    if (colourway == noElement)
        return replaceWith(design, settingsId, settings, {QT_TRANSLATE_NOOP("Message", "Show no colourway")});
    if (!design.find<Colourway>(colourway))
        return {};
    return replaceWith(design, settingsId, settings,
                       {QT_TRANSLATE_NOOP("Message", "Show colourway %1"), {displayName(design, colourway)}});
}

Edit withColourOf(const Design& design, ElementId patch, ElementId copy)
{
    EditBuilder builder(design);
    design.each<Colourway>([&](ElementId id, Colourway colourway) {
        const auto entry = std::ranges::find(colourway.fabrics, patch, &Colourway::Entry::patch);
        if (entry == colourway.fabrics.end())
            return;
        setEntry(colourway, copy, entry->fabric);
        builder.replace(id, std::move(colourway));
    });
    return builder.result({});
}

} // namespace bolster::edits
