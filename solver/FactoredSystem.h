// A symmetric positive definite system: the constructor factors, solve() is cheap.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>

namespace bolster {

/// CHOLMOD's simplicial Cholesky factor on one thread, deterministic. A system without unknowns is solved, too. Not
/// safe to share between threads, because solve() uses a workspace.
class FactoredSystem {
public:
    /// The lower triangle of the matrix is read; `places` says where its unknowns lie (for the elimination order).
    FactoredSystem(const Eigen::SparseMatrix<double>& matrix, const Eigen::Matrix3Xd& places);
    ~FactoredSystem();
    FactoredSystem(FactoredSystem&&) noexcept;
    FactoredSystem& operator=(FactoredSystem&&) noexcept;

    /// False when the matrix was not positive definite or not finite; solve() must not be called then.
    bool ok() const;
    /// Same pattern, other values: keeps the symbolic analysis. Returns ok().
    bool refactor(const Eigen::SparseMatrix<double>& matrix);
    /// Solves for all columns; `x` gets the size of `b`.
    void solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x);

private:
    struct Cholmod;
    std::unique_ptr<Cholmod> m_cholmod;
};

} // namespace bolster
