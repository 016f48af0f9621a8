// What a scan is aligned with: the triangles of covers and frames.
#pragma once

#include "Placement.h"
#include "TriangleRays.h"

#include <optional>
#include <span>

namespace bolster {

class AlignTarget {
public:
    /// mm, after the placement.
    void add(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
             const Placement& placement = {});
    /// After the last of them; before that nothing is found.
    void build();

    bool empty() const { return m_triangles.empty(); }
    const Box3& box() const { return m_box; }
    /// So many places on it, as many to each area, the same every time. mm.
    std::vector<Vec3> spread(int count) const;

    struct Foot {
        Vec3 point = Vec3::Zero();   ///< mm
        Vec3 normal = Vec3::UnitZ(); ///< unit, of its triangle
    };
    /// Nothing when no triangle is within `reach`, mm.
    std::optional<Foot> nearest(const Vec3& at, double reach) const;

private:
    std::array<Vec3, 3> cornersOf(const std::array<std::uint32_t, 3>& triangle) const;
    Vec3 normalOf(const std::array<std::uint32_t, 3>& corners) const;

    std::vector<Eigen::Vector3f> m_points;
    std::vector<std::array<std::uint32_t, 3>> m_triangles;
    TriangleRays m_rays;
    Box3 m_box;
};

} // namespace bolster
