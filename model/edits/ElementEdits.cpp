#include "ElementEdits.h"

#include "EditBuilder.h"
#include "EditHelpers.h"
#include "Kinds.h"
#include "References.h"

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
    const char* verb = std::visit([]<class T>(const T&) { return Description<T>::added; }, element);
    return {verb, {elementName(element)}};
}

/// A patch does not go with its fabric: fabrics in use stay, and what is none may go.
IsGone isAmong(const std::set<ElementId>& removed)
{
    return [&removed](const Reference& reference) {
        const bool ofPatch = reference.need == Need::Needed && reference.kind == Element(Fabric{}).index();
        return !ofPatch && removed.contains(reference.id);
    };
}

bool isSewing(const Element& element)
{
    return std::holds_alternative<Seam>(element) || std::holds_alternative<FixationSeam>(element);
}

/// Names what goes along: what needs the removed elements.
Message removeVerb(const Design& design, const std::set<ElementId>& removed, const std::set<ElementId>& gone)
{
    const std::size_t changes = gone.size();
    if (removed.size() > 1)
        return {QT_TRANSLATE_NOOP("Message", "Remove %1 elements"), {std::to_string(changes)}};
    const std::string name = displayName(design, *removed.begin());
    if (changes == 1)
        return {QT_TRANSLATE_NOOP("Message", "Remove %1"), {name}};
    if (!std::ranges::all_of(gone,
                             [&](ElementId id) { return removed.contains(id) || isSewing(*design.element(id)); }))
        return {QT_TRANSLATE_NOOP("Message", "Remove %1 and what needs it (%2 elements)"),
                {name, std::to_string(changes - 1)}};
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

Edit changeNote(const Design& design, ElementId id, const std::string& note)
{
    const ElementPtr before = design.element(id);
    const char* const spaces = " \t\r\n";
    const std::size_t first = note.find_first_not_of(spaces);
    const std::string kept =
        first == std::string::npos ? std::string() : note.substr(first, note.find_last_not_of(spaces) + 1 - first);
    if (!before || elementNote(*before) == kept)
        return {};
    return replaceElement(design, id, withNote(*before, kept), {noteField.verb, {displayName(design, id)}});
}

ElementPtr withFreeName(const Design& design, const Element& element)
{
    Element named = element;
    std::visit(
        [&]<class T>(T& value) {
            if constexpr (requires { value.name; })
                value.name = freeNameOf<T>(design, value.name, noElement);
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
            if (goesAlong(*element, isAmong(gone)))
                gone.insert(id);
    }
    Edit edit;
    const auto leave = [&](ElementId id, const ElementPtr& element) {
        if (ElementPtr rest = without(element, isAmong(gone)); rest != element)
            edit.changes.push_back({id, element, std::move(rest)});
    };
    leave(settingsId, design.element(settingsId));
    for (const auto& [id, element] : design.elements()) {
        if (gone.contains(id))
            edit.changes.push_back({id, element, nullptr});
        else
            leave(id, element);
    }
    edit.verb = removeVerb(design, removed, gone);
    return edit;
}

Edit changeSettings(const Design& design, const Settings& settings)
{
    return replaceWith(design, settingsId, settings, {QT_TRANSLATE_NOOP("Message", "Change the settings")});
}

} // namespace bolster::edits
