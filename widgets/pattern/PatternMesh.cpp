#include "PatternMesh.h"

#include "Patch.h"

namespace bolster {

void PatternMesh::setTopology(std::shared_ptr<const SurfaceTopology> topology)
{
    if (topology == m_topology)
        return;
    m_topology = std::move(topology);
    m_patches.clear();
    m_edgeLength = 0;
    if (!m_topology)
        return;
    double length = 0;
    std::size_t count = 0;
    for (const SurfaceTopology::PatchRange& range : m_topology->patches) {
        PatchEdges& patch = m_patches[range.patch];
        patch = {range, edgesOf(*m_topology, range)};
        for (const auto& [a, b] : patch.edges)
            length += (m_topology->pattern[a] - m_topology->pattern[b]).norm();
        count += patch.edges.size();
    }
    m_edgeLength = count ? length / static_cast<double>(count) : 0;
}

QVector<QLineF> PatternMesh::lines(ElementId id, const Patch& patch, const PatternTransform& transform) const
{
    QVector<QLineF> lines;
    const auto found = m_patches.find(id);
    if (found == m_patches.end())
        return lines;
    const auto& [range, edges] = found->second;
    std::vector<QPointF> pixels(range.vertexCount);
    for (std::uint32_t v = 0; v < range.vertexCount; ++v)
        pixels[v] = transform.toPixels(toLayout(patch, m_topology->pattern[range.firstVertex + v]));
    lines.reserve(static_cast<qsizetype>(edges.size()));
    for (const auto& [a, b] : edges)
        lines.append({pixels[a - range.firstVertex], pixels[b - range.firstVertex]});
    return lines;
}

} // namespace bolster
