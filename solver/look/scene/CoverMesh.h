// The cover refined for display: smooth between the solver's vertices. Maps, hits and tools stay on the solver's
// mesh.
#pragma once

#include "SurfaceMesh.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace bolster {

/// What stays the same while only positions move. As in the solver's mesh vertices belong to one patch each; the
/// solver's vertices come first and keep their numbers.
struct CoverTopology {
    using Triangle = std::array<std::uint32_t, 3>;
    /// A vertex lies in a triangle of the solver's mesh: its corners and their shares, which sum to 1.
    struct Parents {
        std::array<std::uint32_t, 3> vertex{};
        std::array<float, 3> share{1, 0, 0};
    };
    /// An edge of the solver's mesh, a < b, and the vertices on it: 1 or 3, from a to b.
    struct Edge {
        std::uint32_t a = 0, b = 0;
        std::array<std::uint32_t, 3> between{};
    };

    std::shared_ptr<const SurfaceTopology> coarse;
    int levels = 0; ///< each makes four triangles of one: 1 or 2
    /// Four or sixteen for each of the solver's, in their order.
    std::vector<Triangle> triangles;
    std::vector<Eigen::Vector2f> pattern; ///< outline coordinates of each vertex, mm
    std::vector<Parents> parents;
    std::vector<Edge> edges;           ///< by increasing a, then b
    std::vector<std::uint32_t> merged; ///< of each vertex: equal for those that share a position

    std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(pattern.size()); }
    std::uint32_t trianglesPerCoarse() const { return 1U << (2 * levels); }
    /// The vertices along a run of the solver's edges.
    std::vector<std::uint32_t> along(std::span<const std::uint32_t> run) const;

    /// A value per vertex of the solver's mesh carried over; what is unknown (NaN) stays so around it.
    template <class T>
    T at(std::uint32_t vertex, const std::vector<T>& ofCoarse) const
    {
        const Parents& from = parents[vertex];
        T sum = from.share[0] * ofCoarse[from.vertex[0]];
        for (std::size_t i = 1; i < 3; ++i)
            if (from.share[i] > 0)
                sum += from.share[i] * ofCoarse[from.vertex[i]];
        return sum;
    }
    template <class T>
    std::vector<T> carriedOver(const std::vector<T>& ofCoarse) const
    {
        std::vector<T> all;
        all.reserve(parents.size());
        for (std::uint32_t v = 0; v < parents.size(); ++v)
            all.push_back(at(v, ofCoarse));
        return all;
    }
};

struct SeamRelief;

struct CoverMesh {
    std::shared_ptr<const CoverTopology> topology;
    SurfaceMeshPtr surface;               ///< what it was made from
    std::vector<Eigen::Vector3f> points;  ///< mm; identical for sewn vertices
    std::vector<Eigen::Vector3f> normals; ///< unit, to the outside; smooth within a patch and over G1 and C1 seams
    std::shared_ptr<const SeamRelief> relief; ///< of the topology; null: all seams are plain ones
};

using CoverMeshPtr = std::shared_ptr<const CoverMesh>;

} // namespace bolster
