#include "VertexAreas.h"

namespace bolster {

std::vector<double> vertexAreas(const SurfaceTopology& topology, const std::vector<Vec3>& positions)
{
    std::vector<double> areas(positions.size(), 0);
    for (const auto& t : topology.triangles) {
        const Vec3& a = positions[t[0]];
        const double area = 0.5 * (positions[t[1]] - a).cross(positions[t[2]] - a).norm();
        for (const std::uint32_t v : t)
            areas[v] += area / 3;
    }
    return areas;
}

} // namespace bolster
