#include "RowModel.h"

#include <utility>

namespace bolster {

RowModel::RowModel(Eigen::MatrixXd jacobian)
    : m_jacobian(std::move(jacobian))
    , m_squares(Eigen::MatrixXd::Zero(m_jacobian.cols(), m_jacobian.cols()))
{
    m_squares.selfadjointView<Eigen::Lower>().rankUpdate(m_jacobian.transpose());
    m_squares.triangularView<Eigen::StrictlyUpper>() = m_squares.transpose();
}

void RowModel::learn(const Eigen::VectorXd& steps, const Eigen::VectorXd& off)
{
    const Eigen::VectorXd along = steps / steps.squaredNorm(), across = m_jacobian.transpose() * off;
    m_squares += across * along.transpose();
    m_squares += along * across.transpose();
    m_squares += off.squaredNorm() * along * along.transpose();
    m_jacobian += off * along.transpose();
}

} // namespace bolster
