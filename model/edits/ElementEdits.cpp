#include "ElementEdits.h"

#include "EditBuilder.h"
#include "EditHelpers.h"

#include <algorithm>

namespace bolster::edits {

namespace {

/// Elements without a name have nothing to be told apart by anyway.
template <class T>
std::string freeNameOf(const Design& design, const std::string& wanted, ElementId own)
{
    return wanted.empty() ? wanted : freeName<T>(design, wanted, own);
}

Message addVerb(const Element& element)
{
    static constexpr std::array<const char*, std::variant_size_v<Element>> keys = {
        QT_TRANSLATE_NOOP("Message", "Change the settings"),
        QT_TRANSLATE_NOOP("Message", "Add fabric %1"),
        QT_TRANSLATE_NOOP("Message", "Add patch %1"),
        QT_TRANSLATE_NOOP("Message", "Add a seam"),
        QT_TRANSLATE_NOOP("Message", "Add fixation curve %1"),
        QT_TRANSLATE_NOOP("Message", "Add a fixation seam"),
        QT_TRANSLATE_NOOP("Message", "Add frame %1"),
        QT_TRANSLATE_NOOP("Message", "Add handle curve %1"),
        QT_TRANSLATE_NOOP("Message", "Add fancy seam %1"),
        QT_TRANSLATE_NOOP("Message", "Add cushion %1"),
        QT_TRANSLATE_NOOP("Message", "Add foam %1"),
        QT_TRANSLATE_NOOP("Message", "Add scan %1"),
        QT_TRANSLATE_NOOP("Message", "Add colourway %1"),
        QT_TRANSLATE_NOOP("Message", "Add a trim"),
        QT_TRANSLATE_NOOP("Message", "Add an unreadable element"),
    };
    return {keys[element.index()], {elementName(element)}};
}

bool refersTo(const Element& element, const std::set<ElementId>& ids)
{
    if (const auto* seam = std::get_if<Seam>(&element))
        return ids.contains(seam->a.patch) || ids.contains(seam->b.patch);
    if (const auto* fixation = std::get_if<FixationSeam>(&element))
        return ids.contains(fixation->stretch.patch) || ids.contains(fixation->curve);
    if (const auto* trimmed = std::get_if<OutlineTrim>(&element))
        return ids.contains(trimmed->stretch.patch);
    if (const PatchCurve* drawn = patchCurve(element))
        return ids.contains(drawn->patch);
    if (const auto* cushion = std::get_if<Cushion>(&element)) {
        const auto& patches = cushion->patches;
        const auto isRemoved = [&](ElementId patch) { return ids.contains(patch); };
        return ids.contains(cushion->frame) ||
               (!patches.empty() && std::all_of(patches.begin(), patches.end(), isRemoved));
    }
    if (const auto* foam = std::get_if<Foam>(&element))
        return ids.contains(foam->cushion);
    return false;
}

/// What is left of an element when it does without the removed ones; null if it does not refer to them.
ElementPtr without(const Element& element, const std::set<ElementId>& removed)
{
    Element rest = element;
    if (auto* cushion = std::get_if<Cushion>(&rest))
        std::erase_if(cushion->patches, [&](ElementId patch) { return removed.contains(patch); });
    if (auto* colourway = std::get_if<Colourway>(&rest))
        std::erase_if(colourway->fabrics, [&](const Colourway::Entry& entry) {
            return removed.contains(entry.patch) || removed.contains(entry.fabric);
        });
    if (auto* settings = std::get_if<Settings>(&rest); settings && removed.contains(settings->colourway))
        settings->colourway = {};
    if (const SeamTrim* trim = seamTrim(rest); trim && removed.contains(trim->pipingFabric)) {
        SeamTrim plain = *trim;
        plain.pipingFabric = {};
        rest = *withTrim(rest, std::move(plain));
    }
    return rest == element ? nullptr : makeElement(std::move(rest));
}

/// Names what goes along: seams and fixations that need the removed elements.
Message removeVerb(const Design& design, const std::set<ElementId>& removed, std::size_t changes)
{
    if (removed.size() > 1)
        return {QT_TRANSLATE_NOOP("Message", "Remove %1 elements"), {std::to_string(changes)}};
    const std::string name = displayName(design, *removed.begin());
    if (changes == 1)
        return {QT_TRANSLATE_NOOP("Message", "Remove %1"), {name}};
    if (changes == 2)
        return {QT_TRANSLATE_NOOP("Message", "Remove %1 and what is sewn to it"), {name}};
    return {QT_TRANSLATE_NOOP("Message", "Remove %1 and %2 seams and fixations"),
            {name, std::to_string(changes - 1)}};
}

} // namespace

Edit addElement(const Design& design, ElementPtr element)
{
    if (!element || std::holds_alternative<Settings>(*element))
        return {};
    Edit edit{addVerb(*element), {}};
    edit.changes.push_back({design.nextId(), nullptr, std::move(element)});
    return edit;
}

Edit replaceElement(const Design& design, ElementId id, ElementPtr element, Message verb)
{
    const ElementPtr before = design.element(id);
    const bool settings = element && std::holds_alternative<Settings>(*element);
    if (!before || !element || settings != (id == settingsId) || *before == *element)
        return {};
    return {std::move(verb), {{id, before, std::move(element)}}};
}

Edit renameElement(const Design& design, ElementId id, const std::string& name)
{
    const ElementPtr before = design.element(id);
    if (!before)
        return {};
    Element renamed = *before;
    std::string free = name;
    std::visit(
        [&]<class T>(T& value) {
            if constexpr (requires { value.name; })
                if (value.name != name) { // two that have the same one from elsewhere may keep it
                    free = freeNameOf<T>(design, name, id);
                    value.name = free;
                }
        },
        renamed);
    Edit edit = replaceElement(design, id, std::make_shared<const Element>(std::move(renamed)),
                               {QT_TRANSLATE_NOOP("Message", "Rename %1 to %2"), {displayName(design, id), free}});
    if (free != name)
        edit.note = {QT_TRANSLATE_NOOP("Message", "There is a \"%1\" already: this one is called \"%2\"."),
                     {name, free}};
    return edit;
}

ElementPtr withFreeName(const Design& design, const Element& element)
{
    Element named = element;
    std::visit(
        [&]<class T>(T& value) {
            if constexpr (requires { value.name; })
                value.name = freeNameOf<T>(design, value.name, settingsId);
        },
        named);
    return std::make_shared<const Element>(std::move(named));
}

Edit removeElements(const Design& design, std::span<const ElementId> ids)
{
    std::set<ElementId> removed;
    for (const ElementId id : ids)
        if (id != settingsId && design.element(id))
            removed.insert(id);
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        if (!removed.contains(id) && design.find<Fabric>(patch.fabric))
            removed.erase(patch.fabric);
    });
    if (removed.empty())
        return {};

    std::set<ElementId> gone = removed;
    for (std::size_t before = 0; before != gone.size();) { // a frame takes its cushions along, and they their foam
        before = gone.size();
        for (const auto& [id, element] : design.elements())
            if (refersTo(*element, gone))
                gone.insert(id);
    }
    Edit edit;
    const auto leave = [&](ElementId id, const ElementPtr& element) {
        if (ElementPtr rest = without(*element, gone))
            edit.changes.push_back({id, element, std::move(rest)});
    };
    leave(settingsId, design.element(settingsId));
    for (const auto& [id, element] : design.elements()) {
        if (gone.contains(id))
            edit.changes.push_back({id, element, nullptr});
        else
            leave(id, element);
    }
    edit.verb = removeVerb(design, removed, gone.size());
    return edit;
}

Edit changeSettings(const Design& design, const Settings& settings)
{
    return replaceWith(design, settingsId, settings, {QT_TRANSLATE_NOOP("Message", "Change the settings")});
}

} // namespace bolster::edits
