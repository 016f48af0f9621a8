// A symmetric positive definite system: the constructor factors, solve() is cheap.
#pragma once

#include "PackedFactor.h"

#include <Eigen/SparseCore>

#include <memory>

namespace bolster {

/// Factored by CHOLMOD in double precision on one thread, solved with in single precision (PackedFactor): for
/// corrections, which the next residual puts right. Not safe to share between threads, because solve() uses a
/// workspace. A system without unknowns is solved, too.
class FactoredSystem {
public:
    /// The lower triangle of the matrix is read; `places` says where its unknowns lie (for the elimination order).
    FactoredSystem(const Eigen::SparseMatrix<double>& matrix, const Eigen::Matrix3Xd& places);
    ~FactoredSystem();
    FactoredSystem(FactoredSystem&&) noexcept;
    FactoredSystem& operator=(FactoredSystem&&) noexcept;

    /// False when the matrix was not positive definite or not finite; solve() must not be called then.
    bool ok() const { return m_ok; }
    /// Same pattern, other values: keeps the symbolic analysis. Returns ok().
    bool refactor(const Eigen::SparseMatrix<double>& matrix);
    /// Where each unknown lies in the vectors of solve().
    const std::vector<int>& slots() const { return m_packed.slots(); }
    /// x := A^-1 x for four right-hand sides.
    void solve(PackedFactor::Vectors& x, WorkerPool& pool) { m_packed.solve(x, pool); }

private:
    struct Cholmod;
    std::unique_ptr<Cholmod> m_cholmod;
    PackedFactor m_packed;
    bool m_ok = false;
};

} // namespace bolster
