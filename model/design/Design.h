// Everything the user made, as an immutable value.
#pragma once

#include "Edit.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <set>

namespace bolster {

/// Copying is cheap: elements are shared between versions.
class Design {
public:
    using Elements = std::map<ElementId, ElementPtr>; ///< without the settings

    Design();

    const Elements& elements() const { return *m_elements; }
    const Settings& settings() const;
    /// The element, the settings for settingsId, or null.
    ElementPtr element(ElementId id) const;
    /// The element if it exists and is of this kind, or null.
    template <class T>
    const T* find(ElementId id) const
    {
        const ElementPtr found = element(id);
        return found ? std::get_if<T>(found.get()) : nullptr; // alive as long as the design
    }
    /// Calls visit(id, const T&) for each element of this kind, by increasing id.
    template <class T, class Visit>
    void each(Visit visit) const
    {
        for (const auto& [id, element] : *m_elements)
            if (const T* value = std::get_if<T>(element.get()))
                visit(id, *value);
    }

    /// How many elements of this kind there are.
    template <class T>
    int count() const
    {
        int found = 0;
        each<T>([&found](ElementId, const T&) { ++found; });
        return found;
    }

    /// A free id, larger than all others and than those that are spent.
    ElementId nextId() const;
    /// Up to this one `nextId` gives none any more, here and in what is made of this: other branches have given
    /// them to other things. No part of the content.
    void spendIds(ElementId upTo) { m_spent = std::max(m_spent, number(upTo)); }
    ElementId largestId() const;
    /// The design after the edit. `before` is not looked at.
    Design with(const Edit& edit) const&;
    /// The same without a copy of the elements' table if nobody else has it: for edits made step by step.
    Design with(const Edit& edit) &&;

    /// Same content; shared elements are not compared twice.
    friend bool operator==(const Design& a, const Design& b);

private:
    static void apply(const Change& change, Elements& elements);
    void applySettings(const Change& change);

    ElementPtr m_settings;
    std::shared_ptr<const Elements> m_elements; // made as one that can be changed
    std::int32_t m_spent = 0;
};

/// The ids in which two designs differ, settings included. Elements are compared by pointer, then by value.
std::set<ElementId> differences(const Design& a, const Design& b);

/// The edit that leads from one design to another.
Edit editBetween(const Design& from, const Design& to, Message verb);

} // namespace bolster
