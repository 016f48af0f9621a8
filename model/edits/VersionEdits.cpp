#include "VersionEdits.h"

#include "EditBuilder.h"
#include "ElementEdits.h"
#include "ElementFields.h"
#include "References.h"

#include <algorithm>
#include <map>

namespace bolster {

namespace {

void addFields(Difference& difference, const ElementFields& before, const ElementFields& after)
{
    const auto valueIn = [](const ElementFields& fields, const std::string& key) {
        const auto found = fields.find(key);
        return found == fields.end() ? std::string() : found->second;
    };
    std::set<std::string> keys;
    for (const ElementFields* fields : {&before, &after})
        for (const auto& [key, value] : *fields)
            keys.insert(key);
    for (const std::string& key : keys)
        if (const Difference::Field field{key, valueIn(before, key), valueIn(after, key)};
            field.before != field.after)
            difference.fields.push_back(field);
}

/// Without those that an element can do without: a twin.
std::set<ElementId> neededBy(const Element& element)
{
    std::set<ElementId> needed;
    for (const Reference& reference : references(element))
        if (isNeeded(reference))
            needed.insert(reference.id);
    return needed;
}

/// What is only seen: without it there is less to see, no more.
std::set<ElementId> seenIn(const Element& element)
{
    std::set<ElementId> seen;
    for (const Reference& reference : references(element))
        if (reference.need == Need::Seen)
            seen.insert(reference.id);
    return seen;
}

/// A colourway without what it says of patches that are not there, and the like.
ElementPtr withoutMissing(const Design& design, const ElementPtr& element)
{
    return without(element, [&](const Reference& reference) {
        const ElementPtr there = design.element(reference.id);
        return reference.need != Need::Listed && (!there || there->index() != reference.kind);
    });
}

/// All that comes along when elements are taken from another version.
class Taking {
public:
    Taking(const Design& design, const Design& other)
        : m_design(design)
        , m_other(other)
    {}

    void take(ElementId id)
    {
        const ElementPtr element = m_other.element(id);
        if (!m_taken.insert(id).second || !element)
            return;
        for (const ElementId needed : neededBy(*element))
            if (!m_design.element(needed))
                take(needed);
    }

    void takeFabricsSeen()
    {
        const std::set<ElementId> asked = m_taken;
        for (const ElementId id : asked)
            if (const ElementPtr element = m_other.element(id))
                for (const ElementId fabric : seenIn(*element))
                    if (!m_design.element(fabric))
                        take(fabric);
    }

    /// What lies on the outlines of the patches, as far as everything else that it needs is there.
    void takeWhatLiesOnPatches()
    {
        const std::set<ElementId> asked = m_taken;
        for (const auto& [id, element] : m_other.elements()) {
            const std::set<ElementId> needed = neededBy(*element);
            const auto isThere = [&](ElementId n) { return m_design.element(n) || m_taken.contains(n); };
            const auto isAsked = [&](ElementId n) { return asked.contains(n) && m_other.find<Patch>(n); };
            if (liesOnPatch(*element) && std::ranges::any_of(needed, isAsked) &&
                std::ranges::all_of(needed, isThere))
                m_taken.insert(id);
        }
    }

    Design result() const
    {
        std::vector<ElementId> gone; // or quite another thing by the same number
        for (const ElementId id : m_taken)
            if (const ElementPtr there = m_design.element(id), wanted = m_other.element(id);
                there && (!wanted || wanted->index() != there->index()))
                gone.push_back(id);
        edits::EditBuilder builder(m_design.with(edits::removeElements(m_design, gone)));
        for (const ElementId id : m_taken)
            if (const ElementPtr wanted = m_other.element(id))
                builder.set(id, wanted);
        for (const ElementId id : m_taken)
            if (const ElementPtr element = builder.now().element(id))
                builder.set(id, withoutMissing(builder.now(), element));
        return builder.now();
    }

private:
    const Design& m_design;
    const Design& m_other;
    std::set<ElementId> m_taken;
};

} // namespace

std::vector<Difference> differencesBetween(const Design& a, const Design& b)
{
    std::vector<Difference> found;
    for (const ElementId id : differences(a, b)) {
        const ElementPtr before = a.element(id), after = b.element(id);
        Difference difference{id, Difference::Kind::Changed, {}};
        if (!before)
            difference.kind = Difference::Kind::Added;
        else if (!after)
            difference.kind = Difference::Kind::Removed;
        else
            addFields(difference, elementFields(id, before), elementFields(id, after));
        found.push_back(std::move(difference));
    }
    return found;
}

Design numberedApart(const Design& design, const Design& other)
{
    std::map<ElementId, ElementId> moved;
    std::int32_t next = std::max(number(design.nextId()), number(other.nextId()));
    for (const auto& [id, element] : other.elements())
        if (const ElementPtr here = design.element(id); here && here->index() != element->index())
            moved[id] = ElementId{next++};
    if (moved.empty())
        return other;
    edits::EditBuilder builder(other);
    const auto idFor = [&](const Reference& reference) {
        const auto found = moved.find(reference.id);
        return found == moved.end() ? reference.id : found->second;
    };
    for (const auto& [id, element] : other.elements()) {
        const auto found = moved.find(id);
        if (found != moved.end())
            builder.set(id, nullptr);
        builder.set(found == moved.end() ? id : found->second, makeElement(renumbered(*element, idFor)));
    }
    return builder.now();
}

namespace edits {

Edit takeFrom(const Design& design, const Design& other, const std::set<ElementId>& ids)
{
    Taking taking(design, other);
    for (const ElementId id : ids)
        taking.take(id);
    taking.takeWhatLiesOnPatches();
    taking.takeFabricsSeen();
    const Design& named = !ids.empty() && other.element(*ids.begin()) ? other : design;
    Message verb{QT_TRANSLATE_NOOP("Message", "Take %1 elements from another version"),
                 {std::to_string(ids.size())}};
    if (ids.size() == 1)
        verb = {QT_TRANSLATE_NOOP("Message", "Take %1 from another version"), {displayName(named, *ids.begin())}};
    Edit edit = editBetween(design, taking.result(), std::move(verb));
    return edit.empty() ? Edit{} : edit;
}

} // namespace edits
} // namespace bolster
