// A symmetric positive definite system that is cheap to solve, again and again.
#pragma once

#include "PackedFactor.h"

#include <Eigen/SparseCore>

namespace bolster {

/// Factored in double precision, solved with in single precision (PackedFactor): for corrections, which the next
/// residual puts right. Not safe to share between threads, because solve() uses a workspace. A system without
/// unknowns is solved, too.
class FactoredSystem {
public:
    /// Finds the order of elimination and the structure of the factor. The lower triangle of the matrix is read;
    /// every column has a diagonal entry. `places` says where its unknowns lie: neighbours should be near each
    /// other. When stopped, factor() fails.
    FactoredSystem(const Eigen::SparseMatrix<double>& matrix, const Eigen::Matrix3Xd& places,
                   const std::stop_token& stop = {});
    /// In an order that is known already.
    FactoredSystem(const Eigen::SparseMatrix<double>& matrix, std::vector<int> order,
                   const std::stop_token& stop = {});

    /// The numbers of this matrix or another of the same pattern. Returns ok(): false when it was not positive
    /// definite or not finite, or when stopped; solve() must not be called then.
    bool factor(const Eigen::SparseMatrix<double>& matrix, WorkerPool& pool, const std::stop_token& stop = {});
    bool ok() const { return m_ok; }
    /// Where each unknown lies in x().
    const std::vector<int>& slots() const { return m_packed.slots(); }
    /// Four right-hand sides, then four solutions.
    PackedFactor::Workspace x() { return m_packed.x(); }
    /// x := A^-1 x.
    void solve(WorkerPool& pool) { m_packed.solve(pool); }
    /// Memory that a solve reads twice.
    std::size_t bytes() const { return m_packed.bytes(); }

private:
    PackedFactor m_packed;
    bool m_ordered = false;
    bool m_ok = false;
};

} // namespace bolster
