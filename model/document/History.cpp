#include "History.h"

#include <algorithm>
#include <cassert>

namespace bolster {

void NamesHash::add(NodeId node, std::string_view version, std::string_view branch)
{
    if (version.empty() && branch.empty())
        return;
    m_any = true;
    m_hash.addData(QByteArray::number(node));
    for (const std::string_view name : {version, branch}) {
        m_hash.addData(QByteArray::number(static_cast<qulonglong>(name.size())) + ':');
        m_hash.addData(QByteArrayView(name.data(), static_cast<qsizetype>(name.size())));
    }
}

History::History()
    : m_nodes(1)
{
    m_nodes.front().time = QDateTime::currentDateTimeUtc();
}

History::History(std::vector<Node> nodes, NodeId current, std::shared_ptr<StoredEdits> edits)
    : m_nodes(std::move(nodes))
    , m_current(current)
    , m_stored(std::move(edits))
{
    for (NodeId id = 0; id < count(); ++id) {
        m_nodes[static_cast<std::size_t>(id)].stored = true;
        if (id == 0)
            continue;
        m_nodes[static_cast<std::size_t>(node(id).parent)].children.push_back(id);
    }
    for (Node& each : m_nodes)
        if (each.lastVisitedChild < 0 && !each.children.empty())
            each.lastVisitedChild = each.children.back();
}

NodeId History::append(Edit edit)
{
    const NodeId id = count();
    m_nodes.push_back({m_current, {}, -1, std::move(edit), QDateTime::currentDateTimeUtc(), {}, {}});
    Node& parent = m_nodes[static_cast<std::size_t>(m_current)];
    parent.children.push_back(id);
    parent.lastVisitedChild = id;
    m_current = id;
    return id;
}

void History::takeIn(std::vector<Node> nodes, std::shared_ptr<StoredEdits> edits)
{
    const NodeId before = count();
    for (Node& each : nodes) {
        const NodeId id = count();
        each.stored = true;
        m_nodes.push_back(std::move(each));
        Node& parent = m_nodes[static_cast<std::size_t>(node(id).parent)];
        parent.children.push_back(id);
        if (parent.lastVisitedChild < 0 || parent.lastVisitedChild >= before)
            parent.lastVisitedChild = id;
    }
    if (!m_stored)
        m_stored = std::move(edits);
}

std::optional<Design> History::moveTo(NodeId id, const Design& design)
{
    std::optional<Design> there = designAt(id, design);
    if (!there)
        return std::nullopt;
    const std::vector<NodeId> path = pathTo(id);
    for (std::size_t i = 1; i < path.size(); ++i)
        m_nodes[static_cast<std::size_t>(path[i - 1])].lastVisitedChild = path[i];
    m_current = id;
    return there;
}

std::optional<Design> History::designAt(NodeId id, const Design& design) const
{
    assert(id >= 0 && id < count());
    if (id == m_current) // as with every edit that is recorded: no need to go up to the root
        return design;
    const std::vector<NodeId> here = pathTo(m_current);
    const std::vector<NodeId> there = pathTo(id);
    const auto [up, down] = std::mismatch(here.begin(), here.end(), there.begin(), there.end());

    std::optional<Design> result = design;
    for (auto leaving = here.end(); result && leaving != up;)
        result = step(*--leaving, *result, StoredEdits::Known::Child);
    for (auto entering = down; result && entering != there.end(); ++entering)
        result = step(*entering, *result, StoredEdits::Known::Parent);
    return result;
}

std::optional<Design> History::step(NodeId id, const Design& design, StoredEdits::Known known) const
{
    const Node& through = node(id);
    const std::optional<Edit> stored = through.stored ? m_stored->edit(id, design, known) : std::nullopt;
    if (through.stored && !stored)
        return std::nullopt;
    const Edit& edit = stored ? *stored : through.edit;
    return design.with(known == StoredEdits::Known::Parent ? edit : edit.inverse());
}

std::optional<NodeId> History::branchOf(NodeId id) const
{
    for (; id > 0; id = node(id).parent)
        if (node(node(id).parent).children.size() > 1)
            return id;
    return std::nullopt;
}

std::vector<NodeId> History::pathTo(NodeId id) const
{
    std::vector<NodeId> path;
    for (NodeId at = id; at >= 0; at = node(at).parent)
        path.push_back(at);
    std::reverse(path.begin(), path.end());
    return path;
}

HistoryMark History::mark() const
{
    NamesHash names;
    for (NodeId id = 0; id < count(); ++id)
        names.add(id, node(id).name, node(id).branch);
    return {m_current, count(), names.value()};
}

} // namespace bolster
