// Keeps a cover that nothing holds from drifting and spinning.
#pragma once

#include "SewnMesh.h"

#include <Eigen/Core>

#include <span>

namespace bolster {

/// One sewn component without fixations. Pressure on rest areas leaves a small net force and torque, which only the
/// proximal term would resist; a free body would sail away.
class FreeBody {
public:
    /// `parts` of the component.
    FreeBody(const SewnMesh& mesh, std::span<const int> parts);

    /// Takes net force and net torque out of `residual` (x y z 0, one column per free unknown, where `slots`
    /// says), in proportion to area.
    void balance(const Eigen::Matrix4Xd& positions, const std::vector<int>& slots,
                 Eigen::Ref<Eigen::Matrix4Xf> residual) const;

private:
    struct Mass {
        int unknown = 0;
        double area = 0;
    };
    std::vector<Mass> m_masses;
    double m_area = 0;
};

} // namespace bolster
