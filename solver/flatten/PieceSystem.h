// The system of a piece that is laid flat.
#pragma once

#include "FactoredSystem.h"

#include <Eigen/SparseCholesky>

#include <memory>

namespace bolster {

/// Symmetric and positive definite; only the lower triangle is given. In single precision (FactoredSystem), so what
/// is solved for are corrections; or, where that loses too much, as of strips thousands of times as long as wide,
/// in double precision.
class PieceSystem {
public:
    using Matrix = Eigen::SparseMatrix<double>;

    /// `order` of elimination (NestedDissection). When stopped, factor() fails.
    PieceSystem(const Matrix& lower, std::vector<int> order, const std::stop_token& stop);

    /// Of this matrix or another one of the same pattern. `probe`: what the system is softest against, a column or
    /// two; single precision does where it is found again. False when the matrix is not positive definite, or when
    /// stopped.
    bool factor(const Matrix& lower, const Eigen::MatrixXd& probe, const std::stop_token& stop);

    /// Of a column or two.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& right);

private:
    Eigen::MatrixXd solveInSingle(const Eigen::MatrixXd& right);

    FactoredSystem m_single;
    std::unique_ptr<Eigen::SimplicialLDLT<Matrix, Eigen::Lower>> m_double;
};

} // namespace bolster
