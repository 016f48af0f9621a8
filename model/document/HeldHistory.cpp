#include "HeldHistory.h"

#include <algorithm>

namespace bolster {

UnsavedWork unsavedWork(const HeldHistory& held, const History& history, const HistoryMark& now)
{
    std::vector<bool> known(static_cast<std::size_t>(now.count), false);
    if (held.designAlone)
        for (const NodeId node : history.pathTo(held.mark.current))
            known[static_cast<std::size_t>(node)] = true;
    else
        std::fill_n(known.begin(), std::min(held.mark.count, now.count), true);

    UnsavedWork unsaved;
    unsaved.edits = static_cast<int>(std::ranges::count(known, false));
    unsaved.elsewhere = unsaved.edits;
    for (const NodeId node : history.pathTo(now.current))
        if (!known[static_cast<std::size_t>(node)])
            --unsaved.elsewhere;
    unsaved.names = now.names != held.mark.names;
    unsaved.another = held.designAlone && now.current != held.mark.current;
    return unsaved;
}

bool holdsAllWork(const HeldHistory& held, const History& history, const HistoryMark& now)
{
    if (now.names != held.mark.names)
        return false;
    if (!held.designAlone)
        return now.count <= held.mark.count;
    return now.current == held.mark.current &&
           static_cast<NodeId>(history.pathTo(held.mark.current).size()) == now.count;
}

} // namespace bolster
