// The tree of edits: editing after an undo starts a sibling branch, nothing is thrown away.
#pragma once

#include "Design.h"

#include <QDateTime>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace bolster {

using NodeId = std::int32_t; ///< 0 is the root: the design as it was opened

class History {
public:
    struct Node {
        NodeId parent = -1;
        std::vector<NodeId> children; ///< oldest first
        NodeId lastVisitedChild = -1; ///< where redo goes
        Edit edit;                    ///< that leads from the parent to this node
        QDateTime time;
        std::string name; ///< that the user gave this version, or ""
    };

    History();

    const Node& node(NodeId id) const { return m_nodes[static_cast<std::size_t>(id)]; }
    NodeId count() const { return static_cast<NodeId>(m_nodes.size()); }
    NodeId current() const { return m_current; }
    bool canUndo() const { return m_current != 0; }
    bool canRedo() const { return node(m_current).lastVisitedChild >= 0; }

    /// Appends an edit below the current node and makes it current.
    NodeId append(Edit edit);
    /// Makes `id` current and remembers the way for redo. Returns the edits to apply, in order.
    std::vector<Edit> moveTo(NodeId id);
    void setName(NodeId id, std::string name) { m_nodes[static_cast<std::size_t>(id)].name = std::move(name); }
    /// The nodes from the root to `id`, both included.
    std::vector<NodeId> pathTo(NodeId id) const;

private:
    std::vector<Node> m_nodes;
    NodeId m_current = 0;
};

} // namespace bolster
