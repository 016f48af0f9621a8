// The numbers of a Cholesky factor, node by node.
#pragma once

#include "SymbolicFactor.h"
#include "WorkerPool.h"

#include <Eigen/Core>

#include <functional>
#include <stop_token>

namespace bolster {

/// Factors P A P^T = L L^T by the multifrontal method (Liu, "The multifrontal method for sparse matrix solution",
/// 1992) in double precision. `values` are those of the matrix that `symbolic` was made of. For each node,
/// take(node, block) gets its columns of L: height() x width, what is above the diagonal undefined. It is called on
/// two threads, for different nodes. The numbers do not depend on the threads. False when the matrix is not
/// positive definite, not finite or hopelessly conditioned, or when stopped.
bool factorFronts(const SymbolicFactor& symbolic, const double* values, WorkerPool& pool,
                  const std::function<void(int, const Eigen::Ref<const Eigen::MatrixXd>&)>& take,
                  const std::stop_token& stop = {});

} // namespace bolster
