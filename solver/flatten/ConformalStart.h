// Where laying a form flat begins.
#pragma once

#include "Facet.h"

#include <span>
#include <stop_token>
#include <vector>

namespace bolster {

/// The conformal map of least squares (Levy et al., "Least squares conformal maps", 2002): the plane places of the
/// vertices, a row for each, in mm, at which triangles keep their angles best. `held`, two of them that should be
/// far apart, are at (0, 0) and (their distance, 0). `places` are those on the form, mm; `order` is that in which
/// to eliminate the vertices. NaN when triangles have no area, all over; when stopped it means nothing.
Eigen::MatrixX2d conformalStart(std::span<const Facet> facets, const Eigen::Matrix3Xd& places,
                                const std::vector<int>& order, std::pair<int, int> held,
                                const std::stop_token& stop);

} // namespace bolster
