#include "CornerWay.h"

#include "ArcLength.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double sameLength = 1e-6; // mm

/// From a to b forwards, of a curve of this length: 0 up to the whole.
double forwardsBetween(double a, double b, double whole)
{
    const double way = b - a - whole * std::floor((b - a) / whole);
    return way < whole ? way : 0;
}

} // namespace

std::optional<CornerWay> wayFromCorner(const BSpline2& outline, double t)
{
    const ArcLength2 length(outline);
    const double whole = length.total(), here = length.at(outline.wrapped(t));
    std::optional<CornerWay> nearest;
    if (!(whole > 0))
        return nearest;
    for (const double corner : outline.corners()) {
        const double ahead = forwardsBetween(length.at(corner), here, whole);
        for (const CornerWay& way : {CornerWay{corner, ahead, true}, CornerWay{corner, whole - ahead, false}})
            if (!nearest || way.length < nearest->length)
                nearest = way;
    }
    return nearest;
}

std::optional<double> endOfWay(const BSpline2& outline, const CornerWay& way)
{
    const ArcLength2 length(outline);
    const double whole = length.total(), start = length.at(way.corner);
    if (!(way.length >= 0))
        return std::nullopt;
    double room = whole;
    for (const double corner : outline.corners()) {
        const double ahead = forwardsBetween(start, length.at(corner), whole);
        if (const double next = way.forwards ? ahead : whole - ahead; next > sameLength)
            room = std::min(room, next);
    }
    if (way.length > room + sameLength)
        return std::nullopt;
    return outline.wrapped(length.parameterAt(start + (way.forwards ? way.length : -way.length)));
}

double turnAt(const BSpline2& outline, double t)
{
    const double step = 1e-5 * outline.period();
    const auto at = [&](double parameter) { return Vec2(outline.at(outline.wrapped(parameter))); };
    const Vec2 before = at(t) - at(t - step), after = at(t + step) - at(t);
    return std::atan2(cross(before, after), before.dot(after));
}

} // namespace bolster
