// An elimination order with little fill for the matrices of meshes.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <stop_token>
#include <vector>

namespace bolster {

/// Geometric nested dissection (George, "Nested dissection of a regular finite element mesh", 1973): halves are
/// eliminated before the few unknowns that part them. `lower` is the lower triangle of the matrix, `places` says
/// where its unknowns lie, in any unit: neighbours should mostly be near each other. Returns the unknowns in their
/// order; a function of its arguments alone, and when stopped any order. Fill is within some percent of METIS's, in
/// a tenth of the time.
std::vector<int> nestedDissection(const Eigen::SparseMatrix<double>& lower, const Eigen::Matrix3Xd& places,
                                  const std::stop_token& stop = {});

} // namespace bolster
