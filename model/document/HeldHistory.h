// What the file of a design holds of its history, and what would be lost without the rest.
#pragma once

#include "History.h"

namespace bolster {

struct HeldHistory {
    HistoryMark mark;        ///< a project: everything that was there then ...
    bool designAlone = true; ///< ... a text: the design of mark.current, the way to which is given up with it
};

/// What would be lost without a question. Merely standing elsewhere in the history of a project is not among it:
/// that was not made, and is remembered.
struct UnsavedWork {
    int edits = 0;        ///< nodes that are in no file
    int elsewhere = 0;    ///< those of them that are not on the way to where one stands: undone, or other branches
    bool names = false;   ///< of versions or branches
    bool another = false; ///< a text holds another design than the one that is seen

    bool any() const { return edits > 0 || names || another; }
    friend bool operator==(const UnsavedWork&, const UnsavedWork&) = default;
};

/// `now` is history.mark(), for whoever has it already.
UnsavedWork unsavedWork(const HeldHistory& held, const History& history, const HistoryMark& now);
/// The same as unsavedWork().any(), at no cost for projects.
bool holdsAllWork(const HeldHistory& held, const History& history, const HistoryMark& now);

} // namespace bolster
