// What rows are near to where they are now: linear in steps. Private to the library.
#pragma once

#include <Eigen/Core>

namespace bolster {

/// With the products of its columns, which take longer than anything else that is done with it.
class RowModel {
public:
    /// A column for each step.
    explicit RowModel(Eigen::MatrixXd jacobian);

    const Eigen::MatrixXd& jacobian() const { return m_jacobian; }
    const Eigen::MatrixXd& squares() const { return m_squares; }
    /// That steps have led so far away from what they should lead to (Broyden 1965: the least change that explains
    /// it).
    void learn(const Eigen::VectorXd& steps, const Eigen::VectorXd& off);

private:
    Eigen::MatrixXd m_jacobian, m_squares;
};

} // namespace bolster
