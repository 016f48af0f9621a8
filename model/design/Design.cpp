#include "Design.h"

#include <algorithm>

namespace bolster {

namespace {

bool sameContent(const ElementPtr& a, const ElementPtr& b)
{
    return a == b || (a && b && *a == *b);
}

// Calls visit(id, in a or null, in b or null) for each id of either, increasing.
template <class Visit>
void walkBoth(const Design::Elements& a, const Design::Elements& b, Visit visit)
{
    auto i = a.begin();
    auto j = b.begin();
    while (i != a.end() || j != b.end()) {
        const bool fromA = j == b.end() || (i != a.end() && i->first <= j->first);
        const bool fromB = i == a.end() || (j != b.end() && j->first <= i->first);
        visit(fromA ? i->first : j->first, fromA ? i->second : nullptr, fromB ? j->second : nullptr);
        if (fromA)
            ++i;
        if (fromB)
            ++j;
    }
}

} // namespace

Edit Edit::inverse() const
{
    Edit edit{verb, {}};
    edit.changes.reserve(changes.size());
    for (auto change = changes.rbegin(); change != changes.rend(); ++change)
        edit.changes.push_back({change->id, change->after, change->before});
    return edit;
}

Design::Design()
    : m_settings(makeElement(Settings{}))
    , m_elements(std::make_shared<Elements>())
{}

const Settings& Design::settings() const
{
    return std::get<Settings>(*m_settings);
}

ElementPtr Design::element(ElementId id) const
{
    if (id == settingsId)
        return m_settings;
    const auto found = m_elements->find(id);
    return found == m_elements->end() ? nullptr : found->second;
}

ElementId Design::largestId() const
{
    return m_elements->empty() ? noElement : m_elements->rbegin()->first;
}

ElementId Design::nextId() const
{
    const std::int32_t largest = std::max(number(largestId()), m_spent);
    if (largest < largestElementId)
        return ElementId{largest + 1};
    std::int32_t free = 1; // only files that use the largest id come here
    for (const auto& entry : *m_elements) {
        if (number(entry.first) > free)
            break;
        free = number(entry.first) + 1;
    }
    return ElementId{free};
}

void Design::applySettings(const Change& change)
{
    const bool usable = change.after && std::holds_alternative<Settings>(*change.after);
    m_settings = usable ? change.after : makeElement(Settings{});
}

void Design::apply(const Change& change, Elements& elements)
{
    if (change.after)
        elements[change.id] = change.after;
    else
        elements.erase(change.id);
}

Design Design::with(const Edit& edit) const&
{
    return Design(*this).with(edit);
}

Design Design::with(const Edit& edit) &&
{
    std::shared_ptr<Elements> elements;
    for (const Change& change : edit.changes) {
        if (change.id == settingsId) {
            applySettings(change);
            continue;
        }
        if (!elements)
            elements = m_elements.use_count() == 1 ? std::const_pointer_cast<Elements>(m_elements)
                                                   : std::make_shared<Elements>(*m_elements);
        apply(change, *elements);
    }
    if (elements)
        m_elements = std::move(elements);
    return std::move(*this);
}

bool operator==(const Design& a, const Design& b)
{
    if (!sameContent(a.m_settings, b.m_settings))
        return false;
    return a.m_elements == b.m_elements ||
           std::equal(
               a.m_elements->begin(), a.m_elements->end(), b.m_elements->begin(), b.m_elements->end(),
               [](const auto& x, const auto& y) { return x.first == y.first && sameContent(x.second, y.second); });
}

std::set<ElementId> differences(const Design& a, const Design& b)
{
    std::set<ElementId> ids;
    if (!sameContent(a.element(settingsId), b.element(settingsId)))
        ids.insert(settingsId);
    if (&a.elements() == &b.elements())
        return ids;
    walkBoth(a.elements(), b.elements(), [&](ElementId id, const ElementPtr& x, const ElementPtr& y) {
        if (!sameContent(x, y))
            ids.insert(id);
    });
    return ids;
}

Edit editBetween(const Design& from, const Design& to, Message verb)
{
    Edit edit{std::move(verb), {}};
    for (const ElementId id : differences(from, to))
        edit.changes.push_back({id, from.element(id), to.element(id)});
    return edit;
}

} // namespace bolster
