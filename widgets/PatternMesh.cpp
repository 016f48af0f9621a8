#include "PatternMesh.h"

#include "Patch.h"

#include <algorithm>

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
        patch.firstVertex = range.firstVertex;
        patch.vertexCount = range.vertexCount;
        patch.edges.reserve(std::size_t{3} * range.triangleCount);
        for (std::uint32_t t = range.firstTriangle; t < range.firstTriangle + range.triangleCount; ++t) {
            const auto& corners = m_topology->triangles[t];
            for (std::size_t i = 0; i < 3; ++i) {
                const auto [a, b] = std::minmax(corners[i], corners[(i + 1) % 3]);
                patch.edges.emplace_back(a - range.firstVertex, b - range.firstVertex);
            }
        }
        std::ranges::sort(patch.edges);
        patch.edges.erase(std::unique(patch.edges.begin(), patch.edges.end()), patch.edges.end());
        for (const auto& [a, b] : patch.edges)
            length +=
                (m_topology->pattern[range.firstVertex + a] - m_topology->pattern[range.firstVertex + b]).norm();
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
    const PatchEdges& edges = found->second;
    std::vector<QPointF> pixels(edges.vertexCount);
    for (std::uint32_t v = 0; v < edges.vertexCount; ++v)
        pixels[v] = transform.toPixels(toLayout(patch, m_topology->pattern[edges.firstVertex + v]));
    lines.reserve(static_cast<qsizetype>(edges.edges.size()));
    for (const auto& [a, b] : edges.edges)
        lines.append({pixels[a], pixels[b]});
    return lines;
}

} // namespace bolster
