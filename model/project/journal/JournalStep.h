// One durable step of a journal. Private to the library.
#pragma once

#include "Journal.h"
#include "SealedRows.h"

namespace bolster {

struct Journal::Step {
    Step(Database& database, const HashSum& seal)
        : transaction(database)
        , rows(database, seal)
    {}

    Transaction transaction;
    SealedRows rows;
    std::vector<Hash> rowHashes; // of the new nodes
    std::vector<int> sinceSnapshot;
    std::map<NodeId, NodeId> redo; // changes; the newest child where a row goes
};

} // namespace bolster
