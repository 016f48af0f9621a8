#include "History.h"

#include <algorithm>
#include <cassert>

namespace bolster {

History::History()
    : m_nodes(1)
{
    m_nodes.front().time = QDateTime::currentDateTimeUtc();
}

NodeId History::append(Edit edit)
{
    const NodeId id = count();
    m_nodes.push_back({m_current, {}, -1, std::move(edit), QDateTime::currentDateTimeUtc(), {}});
    Node& parent = m_nodes[static_cast<std::size_t>(m_current)];
    parent.children.push_back(id);
    parent.lastVisitedChild = id;
    m_current = id;
    return id;
}

std::vector<Edit> History::moveTo(NodeId id)
{
    assert(id >= 0 && id < count());
    const std::vector<NodeId> here = pathTo(m_current);
    const std::vector<NodeId> there = pathTo(id);
    const auto [up, down] = std::mismatch(here.begin(), here.end(), there.begin(), there.end());

    std::vector<Edit> edits;
    for (auto leaving = here.end(); leaving != up;)
        edits.push_back(node(*--leaving).edit.inverse());
    for (auto entering = down; entering != there.end(); ++entering)
        edits.push_back(node(*entering).edit);

    for (std::size_t i = 1; i < there.size(); ++i)
        m_nodes[static_cast<std::size_t>(there[i - 1])].lastVisitedChild = there[i];
    m_current = id;
    return edits;
}

std::vector<NodeId> History::pathTo(NodeId id) const
{
    std::vector<NodeId> path;
    for (NodeId at = id; at >= 0; at = node(at).parent)
        path.push_back(at);
    std::reverse(path.begin(), path.end());
    return path;
}

} // namespace bolster
