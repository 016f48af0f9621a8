// Bends a triangulated pattern after its outlines, so that dragging them needs no new triangulation
// (docs/solver.md).
#pragma once

#include "SewnMesh.h"

#include <Eigen/SparseCholesky>

#include <map>
#include <optional>

namespace bolster {

/// How much a pattern is distorted against an earlier one on the same triangles, at least 1: the factor by which
/// quadratic forms of the one, as they are in L1 and L2, can exceed those of the other. Infinite where a triangle
/// has been turned over.
double distortion(const std::vector<std::array<std::uint32_t, 3>>& triangles, const std::vector<Vec2>& before,
                  const std::vector<Vec2>& after, WorkerPool& pool);

/// Harmonic displacements of the vertices between outlines and inner lines, always from the pattern as it was
/// triangulated: where a drag ends does not depend on its way.
class PatternWarp {
public:
    explicit PatternWarp(const SewnMesh& mesh);

    /// The pattern with the samples' points where they are now. Nothing when it would be so distorted that it must
    /// be triangulated again.
    std::optional<std::vector<Vec2>> warped(const SewnMesh& mesh, const OutlineSampling& sampling,
                                            WorkerPool& pool);

private:
    /// The vertices between those that follow outline and lines.
    struct Inside {
        std::vector<int> vertices;
        std::vector<SewnMesh::RingEdge> edges; ///< as triangulated, ring after ring
        std::vector<int> firstEdge;            ///< per vertex, and one more
        Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> laplacian;

        Inside(const SewnMesh& mesh, int part);
        /// Of its vertices, from those around it. False when that cannot be.
        bool solve(std::vector<Vec2>& moves) const;
    };

    bool follow(const SewnMesh& mesh, const OutlineSampling& sampling, int part, std::vector<Vec2>& moves) const;

    std::vector<std::array<std::uint32_t, 3>> m_triangles;
    std::vector<Vec2> m_base;
    std::map<int, Inside> m_insides; // by part, of those that have been warped
};

} // namespace bolster
