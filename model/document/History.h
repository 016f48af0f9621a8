// The tree of edits: editing after an undo starts a sibling branch, nothing is thrown away.
#pragma once

#include "Design.h"

#include <QByteArray>
#include <QCryptographicHash>
#include <QDateTime>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bolster {

using NodeId = std::int32_t; ///< 0 is the root: the design as it was opened, or the first one of a project

/// Where the edits of an opened project lie until somebody goes there: a project may have 100,000 of them.
class StoredEdits {
public:
    enum class Known { Parent, Child };

    virtual ~StoredEdits() = default;
    /// The edit that leads to `node`, always forward; `design` is that of the node's parent or its own one. Nothing
    /// when the edit cannot be read any more.
    virtual std::optional<Edit> edit(NodeId node, const Design& design, Known known) = 0;
};

/// Tells a history from an earlier one of itself: nodes are only ever added.
struct HistoryMark {
    NodeId current = 0;
    NodeId count = 1;
    QByteArray names; ///< NamesHash of all versions and branches

    friend bool operator==(const HistoryMark&, const HistoryMark&) = default;
};

/// Of the names that a user gave, taken up from the lowest node to the highest.
class NamesHash {
public:
    void add(NodeId node, std::string_view version, std::string_view branch);
    /// "" when there are no names.
    QByteArray value() const { return m_any ? m_hash.result() : QByteArray(); }

private:
    QCryptographicHash m_hash{QCryptographicHash::Blake2b_256};
    bool m_any = false;
};

class History {
public:
    struct Node {
        NodeId parent = -1;
        std::vector<NodeId> children; ///< oldest first
        NodeId lastVisitedChild = -1; ///< where redo goes
        Edit edit;                    ///< that leads from the parent to this node; of a stored one only the verb
        QDateTime time;
        std::string name;    ///< that the user gave this version, or ""
        std::string branch;  ///< that the user gave the branch that begins with this node, or ""
        bool stored = false; ///< the changes lie in the project
    };

    History();
    /// That of an opened project: the root first, parents before children, ids in the nodes' order. Nodes need
    /// parent, verb, time, name and, where it isn't the newest child, lastVisitedChild.
    History(std::vector<Node> nodes, NodeId current, std::shared_ptr<StoredEdits> edits);

    const Node& node(NodeId id) const { return m_nodes[static_cast<std::size_t>(id)]; }
    NodeId count() const { return static_cast<NodeId>(m_nodes.size()); }
    NodeId current() const { return m_current; }
    bool canUndo() const { return m_current != 0; }
    bool canRedo() const { return node(m_current).lastVisitedChild >= 0; }

    /// Appends an edit below the current node and makes it current.
    NodeId append(Edit edit);
    /// Appends nodes that are stored, children of any before them; ids, fields and `edits` as for an opened
    /// project. The current node and the ways for redo stay as they are.
    void takeIn(std::vector<Node> nodes, std::shared_ptr<StoredEdits> edits);
    /// Makes `id` current and remembers the way for redo. `design` is that of the current node; returns that of
    /// `id`, or nothing when a stored edit on the way cannot be read: then nothing has changed.
    std::optional<Design> moveTo(NodeId id, const Design& design);
    /// The design of `id`, without going there.
    std::optional<Design> designAt(NodeId id, const Design& design) const;
    void setName(NodeId id, std::string name) { m_nodes[static_cast<std::size_t>(id)].name = std::move(name); }
    void setBranch(NodeId id, std::string name) { m_nodes[static_cast<std::size_t>(id)].branch = std::move(name); }
    /// Where the branch begins that `id` is on: the nearest node with siblings, from `id` upwards. Nothing where
    /// nobody has gone another way.
    std::optional<NodeId> branchOf(NodeId id) const;
    /// The nodes from the root to `id`, both included.
    std::vector<NodeId> pathTo(NodeId id) const;
    /// Looks at all nodes for their names.
    HistoryMark mark() const;

private:
    std::optional<Design> step(NodeId node, const Design& design, StoredEdits::Known known) const;

    std::vector<Node> m_nodes;
    NodeId m_current = 0;
    std::shared_ptr<StoredEdits> m_stored;
};

} // namespace bolster
