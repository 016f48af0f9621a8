// One step of moving points rigidly onto planes.
#pragma once

#include "Placement.h"

#include <optional>

namespace bolster {

/// A point that moves, and the plane that it belongs to.
struct PlanePair {
    Vec3 point = Vec3::Zero();   ///< mm, from the middle of all
    Vec3 normal = Vec3::UnitZ(); ///< of the plane
    double along = 0;            ///< mm, along the normal from the plane to the point
    double weight = 1;
};

/// Gauss and Newton's step for the sum of the squared distances. In directions in which the planes slide on
/// themselves nothing moves. Source: Chen and Medioni, "Object modelling by registration of multiple range images",
/// 1992.
class RigidFit {
public:
    /// Turns are weighed as lengths at `radius` (mm) from the middle.
    RigidFit(const Vec3& middle, double radius)
        : m_middle(middle)
        , m_radius(radius)
    {}

    void add(const PlanePair& pair);
    /// Nothing where there is no finite step. `length`: how far the step goes, mm.
    std::optional<Placement> moved(const Placement& from, double* length = nullptr) const;

private:
    Vec3 m_middle;
    double m_radius;
    Eigen::Matrix<double, 6, 6> m_matrix = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> m_right = Eigen::Matrix<double, 6, 1>::Zero();
};

} // namespace bolster
