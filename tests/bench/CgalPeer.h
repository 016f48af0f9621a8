// The peer for whole iterations: CGAL's Surface_mesh_deformation.
#pragma once

#include "Geometry.h"

#include <array>
#include <memory>
#include <vector>

namespace bolster::bench {

/// A surface of which some vertices are held, as the peers see it.
struct HeldSurface {
    Eigen::Matrix3Xd rest; ///< mm
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> held; ///< vertices
    std::vector<Vec3> targets;
    double diameter = 0; ///< D, mm
};

/// As-rigid-as-possible deformation by CGAL, factored beforehand.
class CgalPeer {
public:
    enum class Energy { Original, SmoothRotations }; ///< ORIGINAL_ARAP, SRE_ARAP

    enum class Solver { Default, Umfpack }; ///< as CGAL comes, or the fastest that its matrix admits

    CgalPeer(const HeldSurface& surface, Energy energy, Solver solver = Solver::Default);
    ~CgalPeer();
    CgalPeer(CgalPeer&&) noexcept;

    /// One solve for the positions and one fit of the rotations each.
    void iterate(int iterations);
    Eigen::Matrix3Xd positions() const;

    struct Deformation; ///< of either energy

private:
    std::unique_ptr<Deformation> m_deformation;
};

} // namespace bolster::bench
