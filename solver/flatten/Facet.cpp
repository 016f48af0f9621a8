#include "Facet.h"

#include <algorithm>

namespace bolster {

static constexpr double leastHeight = 0.005; // of a triangle, of its longest edge, to count in full
static constexpr double noHeight = 1e-6;     // likewise, to have a shape: cuts leave ones without an area

Facet facetOf(const std::array<int, 3>& corners, const std::array<Vec3, 3>& places)
{
    const auto edge = [&](std::size_t k) { return Vec3(places[(k + 1) % 3] - places[k]); };
    const std::size_t base = edge(0).norm() >= edge(1).norm() ? (edge(0).norm() >= edge(2).norm() ? 0 : 2)
                                                              : (edge(1).norm() >= edge(2).norm() ? 1 : 2);
    const double longest = edge(base).norm();
    Facet facet{.corners = corners};
    if (!(longest > 0))
        return facet;
    const Vec3 x = edge(base) / longest, way = places[(base + 2) % 3] - places[base];
    const double along = way.dot(x), height = std::max((way - along * x).norm(), noHeight * longest);
    std::array<Vec2, 3> at;
    at[base] = Vec2(0, 0);
    at[(base + 1) % 3] = Vec2(longest, 0);
    at[(base + 2) % 3] = Vec2(along, height);
    facet.area = longest * height / 2;
    facet.weight = facet.area * std::min(1.0, height / (leastHeight * longest));
    facet.x = x;
    facet.y = (way - along * x).normalized();
    for (int k = 0; k < 3; ++k) {
        const Vec2 opposite = at[(k + 2) % 3] - at[(k + 1) % 3];
        facet.gradient.col(k) = Vec2(-opposite.y(), opposite.x()) / (2 * facet.area);
    }
    return facet;
}

} // namespace bolster
