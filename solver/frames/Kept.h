// What is costly to make and depends on nothing but its key.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

namespace bolster {

/// Rounds of asking: what a round did not ask for goes, unless that round made nothing new (so that what is
/// switched off for a moment is still there afterwards).
template <class Key, class Value>
class Kept {
public:
    using Pointer = std::shared_ptr<const Value>;

    /// The value of this key; made by `make(key)`, which returns a Pointer, if it is not there. Null is not kept.
    template <class Make>
    Pointer get(const Key& key, const Make& make)
    {
        const auto found =
            std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& e) { return e.key == key; });
        if (found != m_entries.end()) {
            found->used = true;
            return found->value;
        }
        Pointer value = make(key);
        if (value)
            m_entries.push_back({key, value, true});
        m_madeSome = true;
        return value;
    }

    void endRound()
    {
        if (m_madeSome)
            std::erase_if(m_entries, [](const Entry& e) { return !e.used; });
        for (Entry& entry : m_entries)
            entry.used = false;
        m_madeSome = false;
    }

private:
    struct Entry {
        Key key;
        Pointer value;
        bool used = false;
    };
    std::vector<Entry> m_entries;
    bool m_madeSome = false;
};

} // namespace bolster
