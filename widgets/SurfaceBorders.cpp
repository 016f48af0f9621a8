#include "SurfaceBorders.h"

#include <algorithm>
#include <set>

namespace bolster {

namespace {

using Edge = SurfaceBorders::Edge;

Edge sorted(std::uint32_t a, std::uint32_t b)
{
    return a < b ? Edge{a, b} : Edge{b, a};
}

std::set<Edge> sewnEdges(const SurfaceTopology& topology)
{
    std::set<Edge> sewn;
    for (const SurfaceTopology::Chain& chain : topology.seams)
        for (const auto* side : {&chain.a, &chain.b})
            for (std::size_t i = 1; i < side->size(); ++i)
                sewn.insert(sorted((*side)[i - 1], (*side)[i]));
    return sewn;
}

} // namespace

void SurfaceBorders::setTopology(std::shared_ptr<const SurfaceTopology> topology)
{
    if (topology == m_topology)
        return;
    m_topology = std::move(topology);
    m_patches.clear();
    m_free.clear();
    m_edges.clear();
    if (!m_topology)
        return;
    const std::set<Edge> sewn = sewnEdges(*m_topology);
    for (const SurfaceTopology::PatchRange& range : m_topology->patches) {
        std::map<Edge, std::pair<int, Edge>> count; // with the edge as its triangle walks it
        for (std::uint32_t t = range.firstTriangle; t < range.firstTriangle + range.triangleCount; ++t)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = m_topology->triangles[t][i], b = m_topology->triangles[t][(i + 1) % 3];
                auto& [times, walked] = count[sorted(a, b)];
                ++times;
                walked = {a, b};
            }
        std::vector<Edge>& border = m_patches[range.patch];
        for (const auto& [edge, how] : count) {
            m_edges.push_back(edge);
            if (how.first != 1)
                continue;
            border.push_back(how.second);
            if (!sewn.contains(edge))
                m_free.push_back(how.second);
        }
    }
}

const std::vector<Edge>& SurfaceBorders::ofPatch(ElementId patch) const
{
    static const std::vector<Edge> none;
    const auto found = m_patches.find(patch);
    return found != m_patches.end() ? found->second : none;
}

std::vector<std::vector<std::uint32_t>> chained(const std::vector<Edge>& edges)
{
    std::map<std::uint32_t, std::uint32_t> next;
    std::set<std::uint32_t> reached;
    for (const Edge& edge : edges) {
        next[edge[0]] = edge[1];
        reached.insert(edge[1]);
    }
    std::vector<std::vector<std::uint32_t>> runs;
    const auto walk = [&](std::uint32_t from) {
        std::vector<std::uint32_t> run{from};
        for (auto at = next.find(from); at != next.end(); at = next.find(run.back())) {
            run.push_back(at->second);
            next.erase(at);
        }
        runs.push_back(std::move(run));
    };
    for (const Edge& edge : edges) // open runs first: they begin where nothing arrives
        if (!reached.contains(edge[0]) && next.contains(edge[0]))
            walk(edge[0]);
    while (!next.empty())
        walk(next.begin()->first);
    return runs;
}

} // namespace bolster
