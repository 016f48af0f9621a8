#include "Orientation.h"

#include <algorithm>

namespace bolster {

Vec3 Orientation::at(double fraction) const
{
    const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(directions.size() - 1);
    const std::size_t first = std::min(static_cast<std::size_t>(place), directions.size() - 1);
    const std::size_t second = std::min(first + 1, directions.size() - 1);
    const double t = place - static_cast<double>(first);
    const Vec3 mixed = (1 - t) * directions[first].normalized() + t * directions[second].normalized();
    const double length = mixed.norm();
    return length > 1e-6 ? Vec3(mixed / length) : Vec3(Vec3::Zero());
}

} // namespace bolster
