// Plain seams as thin dark strips on a cover: views and pictures shade a valley there, other programs have
// triangles alone.
#pragma once

#include "CoverMesh.h"

namespace bolster {

class Design;

/// Along one side of a seam.
struct SeamLine {
    ElementId seam{};
    ElementId patch{};
    std::vector<Eigen::Vector3f> points; ///< mm; pairs: on the seam, and beside it
    std::vector<Eigen::Vector3f> normals;
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< counter-clockwise seen from the outside
};

/// Of all seams between patches that have a valley and no piping.
std::vector<SeamLine> seamLines(const Design& design, const CoverMesh& cover);

} // namespace bolster
