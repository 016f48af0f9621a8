// A triangle of a form, in its own plane.
#pragma once

#include "Geometry.h"

#include <Eigen/Core>

#include <array>

namespace bolster {

struct Facet {
    std::array<int, 3> corners{};                                               ///< vertices of the piece
    Eigen::Matrix<double, 2, 3> gradient = Eigen::Matrix<double, 2, 3>::Zero(); ///< of the hat functions, 1/mm
    double area = 0;                                                            ///< mm^2
    double weight = 0;                                                          ///< of its energy, mm^2
    Vec3 x = Vec3::Zero(), y = Vec3::Zero();                                    ///< of that plane
};

/// One that is little more than its longest edge counts for less: its weights would drown those of all others, and
/// of one without an area it is chance how it lies. The faces of CAD programs can consist of such triangles alone.
Facet facetOf(const std::array<int, 3>& corners, const std::array<Vec3, 3>& places);

} // namespace bolster
