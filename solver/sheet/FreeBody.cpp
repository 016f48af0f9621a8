#include "FreeBody.h"

#include <Eigen/Cholesky>

#include <map>

namespace bolster {

FreeBody::FreeBody(const SewnMesh& mesh, std::span<const int> parts)
{
    std::map<int, double> area;
    for (const int p : parts) {
        const SewnMesh::Part& part = mesh.parts[p];
        for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v)
            area[static_cast<int>(mesh.topology->unknown[v])] += mesh.area[v];
    }
    for (const auto& [unknown, a] : area) {
        m_masses.push_back({unknown, a});
        m_area += a;
    }
}

void FreeBody::balance(const Eigen::Matrix4Xd& positions, const std::vector<int>& slots,
                       Eigen::Ref<Eigen::Matrix4Xf> residual) const
{
    Vec3 centre = Vec3::Zero();
    for (const Mass& mass : m_masses)
        centre += mass.area / m_area * positions.col(mass.unknown).head<3>();
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
    for (const Mass& mass : m_masses) {
        const Vec3 arm = positions.col(mass.unknown).head<3>() - centre;
        const Vec3 pull = residual.col(slots[mass.unknown]).head<3>().cast<double>();
        force += pull;
        torque += arm.cross(pull);
        inertia += mass.area * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
    }
    inertia.diagonal().array() += 1e-12 * inertia.trace() + 1e-300; // all points on a line have no spin about it
    const Vec3 spin = inertia.ldlt().solve(torque);
    for (const Mass& mass : m_masses) {
        const Vec3 arm = positions.col(mass.unknown).head<3>() - centre;
        residual.col(slots[mass.unknown]).head<3>() -=
            (mass.area * (force / m_area + spin.cross(arm))).cast<float>();
    }
}

} // namespace bolster
