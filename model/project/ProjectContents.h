// All that the rows of a project say, checked. Private to the library.
#pragma once

#include "EditCodec.h"
#include "Project.h"
#include "SealedRows.h"

#include <memory>

namespace bolster {

struct ProjectContents {
    std::string uuid;
    std::optional<Hash> base; ///< seal of the project file that this journal goes with
    std::vector<History::Node> nodes;
    std::vector<ProjectNode> facts;             ///< of the same nodes
    std::vector<NodeId> snapshots;              ///< increasing
    std::map<NodeId, NodeId> redo;              ///< where it is not the newest child
    std::map<std::string, std::int64_t> assets; ///< blobs by the file's name
    std::optional<NodeId> saved;                ///< the last save point
    NodeId current = 0;
    HashSum seal;
};

/// Throws DatabaseError when a row was changed, is missing, or contradicts another one.
ProjectContents readContents(Database& database);

/// The changes of a node; nothing when they cannot be read.
std::optional<FieldChanges> changesOf(Database& database, NodeId node);
std::optional<Replayed> snapshotOf(Database& database, NodeId node);

/// The design of a node, from the last snapshot before it. Throws when it does not have the hash that the node
/// says.
Design designOf(Database& database, const ProjectContents& contents, NodeId node);

/// All assets are whole, every node's design has its hash, and each snapshot is its node's design. Throws when not.
/// `Thorough` ends where that takes too long. Returns at how many designs it has looked.
std::int64_t checkThoroughly(Database& database, const ProjectContents& contents, ProjectCheck check);

std::shared_ptr<StoredEdits> storedEdits(std::shared_ptr<Database> database);
/// The contents with which a project was opened, as its user sees them.
OpenedProject opened(ProjectContents contents, Design design, std::shared_ptr<Database> database);

} // namespace bolster
