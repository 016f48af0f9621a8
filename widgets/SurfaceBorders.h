// The edges of a cover's patches: where they are sewn, and where they end.
#pragma once

#include "SurfaceMesh.h"

#include <map>
#include <memory>

namespace bolster {

/// Found anew only when the topology changes.
class SurfaceBorders {
public:
    using Edge = std::array<std::uint32_t, 2>;

    void setTopology(std::shared_ptr<const SurfaceTopology> topology);

    /// All boundary edges of a patch; empty for an unknown one.
    const std::vector<Edge>& ofPatch(ElementId patch) const;
    /// Boundary edges that belong to no seam.
    const std::vector<Edge>& free() const { return m_free; }
    /// Every edge once.
    const std::vector<Edge>& edges() const { return m_edges; }

private:
    std::shared_ptr<const SurfaceTopology> m_topology;
    std::map<ElementId, std::vector<Edge>> m_patches;
    std::vector<Edge> m_free;
    std::vector<Edge> m_edges;
};

/// The edges in the order in which one follows the other, as long runs of vertices.
std::vector<std::vector<std::uint32_t>> chained(const std::vector<SurfaceBorders::Edge>& edges);

} // namespace bolster
