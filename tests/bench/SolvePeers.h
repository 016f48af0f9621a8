// The peers for the solves of an iteration: CHOLMOD and Eigen.
#pragma once

#include <Eigen/SparseCore>

#include <functional>

namespace bolster::bench {

enum class SolvePeer { CholmodSimplicial, CholmodSupernodal, EigenLdlt };

/// Factors a positive definite matrix, of which the lower triangle is given, in the best order that the peer finds
/// by itself, and returns one solve with three right-hand sides: L and L^T, the unknowns in the order of the
/// factor.
std::function<void()> solveBy(SolvePeer peer, const Eigen::SparseMatrix<double>& lower);

} // namespace bolster::bench
