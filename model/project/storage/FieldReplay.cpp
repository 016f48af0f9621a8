#include "FieldReplay.h"

#include <algorithm>

namespace bolster {

FieldReplay::FieldReplay(Replayed from)
    : m_from(std::move(from))
    , m_length(m_from.length)
    , m_elements(m_from.design.elements().size())
{}

bool FieldReplay::add(const FieldChanges& changes)
{
    return std::ranges::all_of(changes, [this](const FieldChange& each) { return change(each); });
}

bool FieldReplay::change(const FieldChange& change)
{
    const auto [found, isNew] = m_fields.try_emplace(change.element);
    ElementFields& fields = found->second;
    const ElementPtr before = m_from.design.element(change.element);
    if (isNew)
        fields = elementFields(change.element, before);
    const bool wasThere = !fields.empty();
    if (const auto old = fields.find(change.field); old != fields.end()) {
        m_length -= static_cast<std::int64_t>(old->first.size() + old->second.size());
        fields.erase(old);
    }
    if (change.after) {
        m_length += static_cast<std::int64_t>(change.field.size() + change.after->size());
        fields.emplace(change.field, *change.after);
    }
    if (change.element != settingsId)
        m_elements += (fields.empty() ? 0 : 1) - (wasThere ? 1 : 0);
    if (fields.empty() && !before)
        m_fields.erase(found); // those that come and go are not kept
    return m_length <= longestStoredDesign && m_elements <= mostStoredElements;
}

std::optional<Replayed> FieldReplay::result() const
{
    Edit edit;
    for (const auto& [id, fields] : m_fields) {
        ElementPtr after = elementFromFields(id, fields);
        if (id == settingsId && !after)
            return std::nullopt;
        edit.changes.push_back({id, m_from.design.element(id), std::move(after)});
    }
    return Replayed{m_from.design.with(edit), m_length, 0};
}

} // namespace bolster
