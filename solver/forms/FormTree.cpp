#include "FormTree.h"

#include "NearestOnTriangle.h"

#include <limits>
#include <numeric>

namespace bolster {

FormTree::FormTree(std::vector<Triangle> triangles, const std::stop_token& stop)
    : m_triangles(std::move(triangles))
{
    std::vector<std::uint32_t> all(m_triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    m_boxes.build(
        all, [&](std::uint32_t t) -> const Triangle& { return m_triangles[t]; }, stop);
}

FormTree::Nearest FormTree::nearestTo(const Vec3& place) const
{
    Nearest best;
    double reach = std::numeric_limits<double>::infinity(); // mm^2
    const auto gap = [&](const Box3& box) { return box.squaredExteriorDistance(place); };
    m_boxes.walk(gap, reach, [&](std::uint32_t at) {
        const std::uint32_t triangle = m_boxes.order()[at];
        const auto& [a, b, c] = m_triangles[triangle];
        const Vec3 near = nearestOnTriangle(place, a, b, c);
        if (const double away = (near - place).squaredNorm(); away < reach) {
            reach = away;
            best = {near, triangle};
        }
        return false;
    });
    return best;
}

} // namespace bolster
