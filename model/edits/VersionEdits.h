// What differs between two versions of a design, and taking parts of one into the other.
#pragma once

#include "Design.h"

#include <set>

namespace bolster {

/// How an element differs between a version and another one.
struct Difference {
    enum class Kind : std::uint8_t { Added, Removed, Changed };
    /// A key of the text form (docs/design-json.md) with its values as JSON; "" where there is none.
    struct Field {
        std::string key;
        std::string before;
        std::string after;

        friend bool operator==(const Field&, const Field&) = default;
    };

    ElementId element{};
    Kind kind = Kind::Changed;
    std::vector<Field> fields; ///< of a changed one, by key

    friend bool operator==(const Difference&, const Difference&) = default;
};

/// From `a` to `b`, by element; the settings come first.
std::vector<Difference> differencesBetween(const Design& a, const Design& b);

/// The other version, in which what has the number of another kind of thing in `design` has a number of its own:
/// branches may have given the same one to both.
Design numberedApart(const Design& design, const Design& other);

namespace edits {

/// Makes the elements as they are in the other version: changed, added or removed. What the added ones refer to
/// comes along where it is missing, and so do the seams, fixations and curves of a patch that is taken, so that
/// they fit its outline; what refers to a removed one goes.
Edit takeFrom(const Design& design, const Design& other, const std::set<ElementId>& ids);

} // namespace edits
} // namespace bolster
