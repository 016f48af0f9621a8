#include "RigidFit.h"

#include <Eigen/Eigenvalues>

namespace bolster {

namespace {

constexpr double leastFraction =
    1e-6; // of the largest eigenvalue: directions in which the planes slide on themselves

} // namespace

void RigidFit::add(const PlanePair& pair)
{
    Eigen::Matrix<double, 6, 1> row;
    row << pair.point.cross(pair.normal) / m_radius, pair.normal;
    m_matrix += pair.weight * row * row.transpose();
    m_right -= pair.weight * pair.along * row;
}

std::optional<Placement> RigidFit::moved(const Placement& from, double* length) const
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> axes(m_matrix);
    Eigen::Matrix<double, 6, 1> step = Eigen::Matrix<double, 6, 1>::Zero();
    for (int k = 0; k < 6; ++k)
        if (axes.eigenvalues()[k] > leastFraction * axes.eigenvalues()[5]) {
            const Eigen::Matrix<double, 6, 1> axis = axes.eigenvectors().col(k);
            step += axis * (axis.dot(m_right) / axes.eigenvalues()[k]);
        }
    if (!step.allFinite())
        return std::nullopt;
    if (length != nullptr)
        *length = step.norm();
    const Vec3 turn = step.head<3>() / m_radius;
    const Quat rotation(
        Eigen::AngleAxisd(turn.norm(), turn.norm() > 0 ? Vec3(turn.normalized()) : Vec3(Vec3::UnitZ())));
    Placement placement = from;
    placement.position = rotation * (from.position - m_middle) + m_middle + step.tail<3>();
    placement.rotation = (rotation * from.rotation).normalized();
    return placement;
}

} // namespace bolster
