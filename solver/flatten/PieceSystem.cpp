#include "PieceSystem.h"

namespace bolster {

static constexpr double foundAgain = 0.02; // of the probe: so much may be off

PieceSystem::PieceSystem(const Matrix& lower, std::vector<int> order, const std::stop_token& stop)
    : m_single(lower, std::move(order), stop)
{}

bool PieceSystem::factor(const Matrix& lower, const Eigen::MatrixXd& probe, const std::stop_token& stop)
{
    m_double.reset();
    WorkerPool alone(1);
    if (!m_single.factor(lower, alone, stop))
        return false;
    const Eigen::MatrixXd pull = lower.selfadjointView<Eigen::Lower>() * probe;
    const Eigen::MatrixXd off = solveInSingle(pull) - probe;
    if (off.allFinite() && off.cwiseAbs().maxCoeff() <= foundAgain * probe.cwiseAbs().maxCoeff())
        return true;
    m_double = std::make_unique<Eigen::SimplicialLDLT<Matrix, Eigen::Lower>>(lower);
    return m_double->info() == Eigen::Success && !stop.stop_requested();
}

Eigen::MatrixXd PieceSystem::solve(const Eigen::MatrixXd& right)
{
    return m_double ? Eigen::MatrixXd(m_double->solve(right)) : solveInSingle(right);
}

Eigen::MatrixXd PieceSystem::solveInSingle(const Eigen::MatrixXd& right)
{
    const std::vector<int>& slots = m_single.slots();
    PackedFactor::Workspace x = m_single.x();
    x.setZero();
    for (Eigen::Index k = 0; k < right.rows(); ++k)
        x.col(slots[k]).head(right.cols()) = right.row(k).transpose().cast<float>();
    WorkerPool alone(1);
    m_single.solve(alone);
    Eigen::MatrixXd solved(right.rows(), right.cols());
    for (Eigen::Index k = 0; k < right.rows(); ++k)
        solved.row(k) = x.col(slots[k]).head(right.cols()).transpose().cast<double>();
    return solved;
}

} // namespace bolster
