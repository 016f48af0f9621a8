// Where a point of the pattern plane lies on the cover.
#pragma once

#include "SurfaceMesh.h"

namespace bolster {

/// A place in a triangle of the cover.
struct PatternPlace {
    std::array<std::uint32_t, 3> corners{};
    Eigen::Vector3d weights = Eigen::Vector3d::Zero(); ///< barycentric, clamped into the triangle
};

/// Finds the triangle of a patch at a point of the pattern plane, through a grid.
class PatternLocator {
public:
    /// `patch` must be one of the topology's, and have triangles. Both must outlive the locator.
    PatternLocator(const SurfaceTopology& topology, const SurfaceTopology::PatchRange& patch);

    /// The triangle that contains the point (outline coordinates, mm), or the nearest one; of points outside of the
    /// patch's box that nearest to where they meet the box.
    PatternPlace locate(const Vec2& point) const;

private:
    std::pair<int, int> cellOf(const Vec2& p) const;
    const std::vector<std::uint32_t>& cell(int column, int row) const;
    void tryTriangle(std::uint32_t triangle, const Vec2& p, PatternPlace& best, double& bestDistance) const;

    const SurfaceTopology& m_topology;
    Box2 m_box;
    double m_cell = 1;
    int m_columns = 1, m_rows = 1;
    std::vector<std::vector<std::uint32_t>> m_cells;
};

} // namespace bolster
