#include "AlignTarget.h"

#include <algorithm>
#include <cmath>

namespace bolster {

void AlignTarget::add(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
                      const Placement& placement)
{
    const auto first = static_cast<std::uint32_t>(m_points.size());
    for (const Vec3& point : points) {
        const Vec3 at = placement.placed(point);
        m_points.push_back(at.cast<float>());
        m_box.extend(at);
    }
    for (const auto& [a, b, c] : triangles)
        if (const std::array<std::uint32_t, 3> corners{first + a, first + b, first + c};
            normalOf(corners).squaredNorm() > 0) // one without an area has neighbours
            m_triangles.push_back(corners);
}

std::array<Vec3, 3> AlignTarget::cornersOf(const std::array<std::uint32_t, 3>& triangle) const
{
    return {m_points[triangle[0]].cast<double>(), m_points[triangle[1]].cast<double>(),
            m_points[triangle[2]].cast<double>()};
}

Vec3 AlignTarget::normalOf(const std::array<std::uint32_t, 3>& triangle) const
{
    const auto [a, b, c] = cornersOf(triangle);
    return (b - a).cross(c - a).normalized();
}

std::vector<Vec3> AlignTarget::spread(int count) const
{
    std::vector<double> sums; // of the areas
    for (const auto& triangle : m_triangles) {
        const auto [a, b, c] = cornersOf(triangle);
        sums.push_back((sums.empty() ? 0 : sums.back()) + (b - a).cross(c - a).norm());
    }
    std::vector<Vec3> places;
    for (int k = 0; k < count && !sums.empty(); ++k) {
        const double at = (k + 0.5) / count * sums.back();
        const auto found = static_cast<std::size_t>(std::ranges::lower_bound(sums, at) - sums.begin());
        const auto [a, b, c] = cornersOf(m_triangles[std::min(found, sums.size() - 1)]);
        // Pairs of numbers that fill a square evenly (M. Roberts, 2018), folded to a triangle.
        double u = std::fmod(0.7548776662466927 * k, 1.0), v = std::fmod(0.5698402909980532 * k, 1.0);
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        places.push_back(a + u * (b - a) + v * (c - a));
    }
    return places;
}

void AlignTarget::build()
{
    m_rays.build(m_points, m_triangles);
}

std::optional<AlignTarget::Foot> AlignTarget::nearest(const Vec3& at, double reach) const
{
    const auto found = m_rays.nearest(at.cast<float>(), static_cast<float>(reach));
    if (!found)
        return std::nullopt;
    return Foot{found->point.cast<double>(), normalOf(m_triangles[found->triangle])};
}

} // namespace bolster
