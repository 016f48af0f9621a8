#include "ToolGeometry.h"

#include <algorithm>
#include <limits>

namespace bolster {

double distanceInPicture(const Camera& camera, const std::vector<Vec3>& points, const Vec2& pixel)
{
    double best = std::numeric_limits<double>::max();
    for (std::size_t i = 1; i < points.size(); ++i) {
        const std::optional<Vec2> from = camera.pixel(points[i - 1]), to = camera.pixel(points[i]);
        if (!from || !to)
            continue;
        const Vec2 edge = *to - *from;
        const double length = edge.squaredNorm();
        const double t = length > 0 ? std::clamp((pixel - *from).dot(edge) / length, 0.0, 1.0) : 0;
        best = std::min(best, (*from + t * edge - pixel).norm());
    }
    return best;
}

} // namespace bolster
