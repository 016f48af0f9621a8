// The one kind of command there is.
#pragma once

#include "Element.h"

#include <vector>

namespace bolster {

/// One element before and after; null means that it does not exist.
struct Change {
    ElementId id{};
    ElementPtr before;
    ElementPtr after;
};

/// A verb with its changes. It stores results, never recipes: undo is the same list read backwards.
struct Edit {
    Message verb; ///< for the menu and the history: "Move 3 points of %1"
    std::vector<Change> changes;
    Message note{}; ///< what is to be said about it at once: something is not quite as it was asked for

    bool empty() const { return changes.empty(); }
    Edit inverse() const;
};

} // namespace bolster
