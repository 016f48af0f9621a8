// Loop subdivision of a triangle mesh as a table of weights, made by OpenSubdiv and kept while the triangles stay.
#pragma once

#include "CoverMesh.h"

#include <memory>

namespace bolster {

/// What is refined. Triangles whose corners are not three different vertices, and edges with more than two
/// triangles, are allowed: there the surface has a crease.
struct LoopMesh {
    std::uint32_t vertexCount = 0;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<std::uint32_t, 2>> creases; ///< edges, beside the borders
    std::vector<std::uint32_t> corners;                ///< vertices that stay where they are
};

/// Weights of each refined vertex over the mesh's vertices; the mesh's own vertices come first.
class LoopStencils {
public:
    /// x, y, z and something that is not looked at: four numbers are one load.
    using Point = Eigen::Vector4f;
    using Points = std::vector<Point, Eigen::aligned_allocator<Point>>;

    LoopStencils() = default;
    /// `levels`: 1 or more. Throws std::runtime_error when OpenSubdiv refuses the mesh.
    LoopStencils(const LoopMesh& mesh, int levels);

    std::size_t count() const { return m_start.empty() ? 0 : m_start.size() - 1; }
    /// The first `count` refined points.
    void apply(const Points& points, std::size_t count, Points& refined) const;

    /// Of the levels 1, 2 ...; all refer to the refined vertices of the last level.
    const std::vector<std::vector<CoverTopology::Triangle>>& triangles() const { return m_triangles; }
    std::vector<CoverTopology::Parents> parents;
    std::vector<CoverTopology::Edge> edges; ///< for at most two levels

private:
    std::vector<std::uint32_t> m_start;
    std::vector<std::uint32_t> m_index;
    std::vector<float> m_weight;
    std::vector<std::vector<CoverTopology::Triangle>> m_triangles;
};

} // namespace bolster
