// Makes an edit step by step. Private to the library.
#pragma once

#include "EditHelpers.h"
#include "FreeNames.h"

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
    void set(ElementId id, ElementPtr element) { apply({{}, {{id, nullptr, std::move(element)}}}); }
    void remove(ElementId id) { set(id, nullptr); }
    void apply(const Edit& edit) { m_now = std::move(m_now).with(edit); }

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

/// The names of the elements of a kind, all but that of `own`. Each one given is taken from then on.
template <class T>
class Names {
public:
    explicit Names(const Design& design, ElementId own = noElement)
    {
        design.each<T>([&](ElementId id, const T& value) {
            if (id != own)
                m_names.take(value.name);
        });
    }

    /// "Seat", or "Seat 2" ... when it is taken.
    std::string free(const std::string& wanted) { return m_names.free(wanted); }

private:
    FreeNames m_names;
};

template <class T>
std::string freeName(const Design& design, const std::string& wanted, ElementId own = noElement)
{
    return Names<T>(design, own).free(wanted);
}

} // namespace bolster::edits
