// Many stored edits at once. Private to the library.
#pragma once

#include "EditCodec.h"

namespace bolster {

/// Puts changes together field by field, where nobody asks for the designs between them: elements are made only at
/// the end, so that an edit costs what it changes, however large the elements and however many there are.
class FieldReplay {
public:
    explicit FieldReplay(Replayed from);

    /// False when it leads to more than any design that is stored.
    bool add(const FieldChanges& changes);
    /// Nothing when that cannot be read.
    std::optional<Replayed> result() const;

private:
    bool change(const FieldChange& change);

    Replayed m_from;
    std::map<ElementId, ElementFields> m_fields; ///< of what was changed; none: it is not there any more
    std::int64_t m_length;
    std::size_t m_elements;
};

} // namespace bolster
