// Makes the cover that is shown of the one that is solved: Loop subdivision (OpenSubdiv), corrected so that it
// neither shrinks nor leaves its fixation curves.
#pragma once

#include "CoverMesh.h"
#include "LoopStencils.h"

#include <memory>

namespace bolster {

/// Keeps what belongs to the topology: the next mesh with the same one costs positions and normals only. Not to be
/// used by two threads at once.
///
/// Loop subdivision approximates: a plain refinement of a ball is smaller than the ball. So it is not given the
/// solver's positions p but c with S c = p nearly, S being what becomes of the solver's vertices: c <- c + (p - S
/// c), a few times for all, and until nothing is left for borders, seams, and lines in patches (fixed and folded
/// ones among them), where marks and fixation curves are drawn. A few steps rather than a solve leave out what is
/// as short as the triangles: an interpolating Loop surface swings there. Pattern coordinates go the same way,
/// patch by patch, so that a flat patch keeps exact ones.
class CoverRefiner {
public:
    /// `levels`: 1 or 2. Throws std::runtime_error when OpenSubdiv refuses the topology, and when a position is not
    /// finite: it would spread.
    CoverMeshPtr refine(const SurfaceMeshPtr& surface, int levels);

    /// The two parts of it, for measuring and for tests.
    void prepare(const std::shared_ptr<const SurfaceTopology>& topology, int levels);
    const LoopStencils& stencils() const { return m_merged; }
    /// What the stencils are applied to, per merged vertex; mm, from `origin`.
    LoopStencils::Points controlPoints(const SurfaceMesh& surface, const Vec3& origin) const;

private:
    bool prepared(const SurfaceTopology& topology, int levels) const;
    void makePattern(CoverTopology& cover) const;
    void findSmoothSeams(const SurfaceTopology& topology);
    std::vector<Eigen::Vector3f> normals(const LoopStencils::Points& points) const;

    std::shared_ptr<const SurfaceTopology> m_coarse;
    std::shared_ptr<const CoverTopology> m_cover;
    LoopStencils m_merged;                ///< over merged vertices: positions
    LoopStencils m_patches;               ///< over the solver's vertices: pattern coordinates
    std::vector<std::uint32_t> m_unknown; ///< of each of the solver's vertices
    std::vector<char> m_heldMerged;
    std::vector<char> m_heldPatches;
    std::vector<std::vector<std::uint32_t>> m_oneNormal; ///< refined vertices on both sides of smooth seams
};

} // namespace bolster
