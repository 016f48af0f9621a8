#include "LinePlaces.h"

#include <cmath>

namespace bolster {

double lengthOf(const std::vector<Vec3>& places)
{
    double length = 0;
    for (std::size_t k = 1; k < places.size(); ++k)
        length += (places[k] - places[k - 1]).norm();
    return length;
}

std::vector<Vec3> evenly(const FormLine& line, double apart)
{
    std::vector<Vec3> places{line.points.front()};
    std::vector<Vec3> corners = line.points;
    if (line.closed)
        corners.push_back(corners.front());
    for (std::size_t k = 1; k < corners.size(); ++k) {
        const Vec3 from = corners[k - 1], way = corners[k] - from;
        const int steps = static_cast<int>(std::ceil(way.norm() / apart)); // none where two points are one
        for (int i = 1; i <= steps; ++i)
            places.emplace_back(from + way * i / steps);
    }
    return places;
}

} // namespace bolster
