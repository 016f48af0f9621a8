// How far the cloth of a cover is strained over what it may be.
#pragma once

#include "Design.h"
#include "SurfaceMesh.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace bolster {

/// A column for each triangle; all but the areas are shares. Cloth that is pressed together counts, too.
struct CoverStrains {
    Eigen::Matrix3Xd strains;             ///< along the grain, across it, shear; or the principal ones, and 0
    Eigen::Matrix3Xd limits;              ///< in their place
    Eigen::VectorXd areas;                ///< of the pattern, mm^2
    std::vector<std::uint32_t> triangles; ///< of the topology
};

/// `places` of the vertices, mm. Of these triangles. Fabrics have limits along the grain, across it and of shear;
/// one `limit` (%) in their place holds in every direction, that is for principal strains, as the map shows them.
CoverStrains coverStrains(const SurfaceTopology& topology, const std::vector<Vec3>& places, const Design& design,
                          const std::optional<double>& limit, const std::vector<std::uint32_t>& triangles);
/// Of all triangles.
CoverStrains coverStrains(const SurfaceTopology& topology, const std::vector<Vec3>& places, const Design& design,
                          const std::optional<double>& limit);

/// Of each triangle: the sum of the squares of what is over the limits, 1. `strains` in place of those.
Eigen::VectorXd squaresOver(const CoverStrains& limits, const Eigen::Matrix3Xd& strains);

struct OverLimit {
    double energy = 0; ///< mean over the area of the squares of what is over the limit, 1
    double area = 0;   ///< share of it where something is
};

OverLimit overLimit(const CoverStrains& strains);

} // namespace bolster
