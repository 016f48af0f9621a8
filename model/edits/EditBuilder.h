// Makes an edit step by step. Private to the library.
#pragma once

#include "EditHelpers.h"

namespace bolster::edits {

class EditBuilder {
public:
    explicit EditBuilder(const Design& start)
        : m_start(start)
        , m_now(start)
    {}

    const Design& now() const { return m_now; }

    template <class T>
    ElementId add(T value)
    {
        const ElementId id = m_now.nextId();
        set(id, makeElement(std::move(value)));
        return id;
    }
    template <class T>
    void replace(ElementId id, T value)
    {
        set(id, makeElement(std::move(value)));
    }
    void set(ElementId id, ElementPtr element) { m_now = m_now.with({{}, {{id, nullptr, std::move(element)}}}); }
    void remove(ElementId id) { set(id, nullptr); }
    void apply(const Edit& edit) { m_now = m_now.with(edit); }

    /// From the start to what it has become; empty when nothing has changed.
    Edit result(Message verb) const
    {
        Edit edit = editBetween(m_start, m_now, std::move(verb));
        return edit.empty() ? Edit{} : edit;
    }

private:
    Design m_start;
    Design m_now;
};

/// "Move Seat" or "Move 3 patches": `one` takes a name, `many` a number.
inline Message patchesVerb(const Design& design, std::span<const ElementId> ids, const char* one, const char* many)
{
    if (ids.size() == 1)
        return {one, {displayName(design, ids.front())}};
    return {many, {std::to_string(ids.size())}};
}

/// "Seat", or "Seat 2" ... when an element of the kind has that name, another one than `own`.
template <class T>
std::string freeName(const Design& design, const std::string& wanted, ElementId own = noElement)
{
    std::set<std::string> taken;
    design.each<T>([&](ElementId id, const T& value) {
        if (id != own)
            taken.insert(value.name);
    });
    if (!taken.contains(wanted))
        return wanted;
    // "Seat 2" is followed by "Seat 3", not by "Seat 2 2".
    std::string stem = wanted;
    const std::size_t space = wanted.find_last_of(' ');
    if (space != std::string::npos && space + 1 < wanted.size() && wanted.size() - space < 8 &&
        wanted.find_first_not_of("0123456789", space + 1) == std::string::npos)
        stem.erase(space);
    for (int count = 2;; ++count)
        if (const std::string name = stem + " " + std::to_string(count); !taken.contains(name))
            return name;
}

} // namespace bolster::edits
