// What sewing does to the cover: a valley along each seam, and the soft bulge of the allowances under it.
#pragma once

#include "CoverMesh.h"

namespace bolster {

class Design;

/// How far each vertex is from the seams of its patch. Seams that meet or lie near each other are on different
/// tracks: so distances change evenly within a triangle, even in a corner where all of its vertices lie on seams,
/// and what is drawn by them does not show the triangles.
struct SeamRelief {
    std::uint64_t topology = 0;             ///< serial of the solver's
    std::vector<Eigen::Vector3f> distances; ///< per vertex and track, in the pattern, mm; large ones are cut off
    std::vector<Eigen::Vector2f>
        shapes; ///< per vertex, of the nearest seam: allowance, mm; 1 with a valley, else 0

    /// The solver's vertices come first in a refined cover: what fits that fits them.
    bool fits(std::uint64_t serial, std::size_t vertices) const
    {
        return topology == serial && distances.size() >= vertices;
    }
};

using SeamReliefPtr = std::shared_ptr<const SeamRelief>;

/// Of all seams between patches, smooth ones, too; fixation seams, fancy seams and free borders make none. Seams
/// that the design does not have are plain ones.
SeamReliefPtr seamRelief(const Design& design, const SurfaceTopology& topology);
SeamReliefPtr seamRelief(const Design& design, const CoverTopology& topology);

/// The cross section of seams that meet: that of seams.glsl on all tracks.
struct SeamProfile {
    float height = 0;                                ///< over the cover without seams, mm
    Eigen::Vector3f slope = Eigen::Vector3f::Zero(); ///< of the height over each distance
    float dark = 0;                                  ///< 1 at the bottom of a valley, 0 outside

    /// `pixel`: what distances change by from one pixel to the next, mm; what is narrower is drawn wider and
    /// fainter.
    static SeamProfile at(const Eigen::Vector3f& distances, const Eigen::Vector2f& shape,
                          const Eigen::Vector3f& pixel);
};

} // namespace bolster
