#include "CurvePath.h"

#include <algorithm>

namespace bolster {

namespace {

/// Where the polynomial pieces between two parameters begin and end.
std::vector<double> breaksBetween(const BSpline2& curve, double from, double to)
{
    std::vector<double> result{from};
    const double period = curve.closed() ? curve.period() : 0;
    const double tiny = 1e-12 * std::max(1.0, curve.period());
    for (const double turn : {0.0, period}) {
        for (const double t : curve.breaks())
            if (t + turn > result.back() + tiny && t + turn < to - tiny)
                result.push_back(t + turn);
        if (period == 0)
            break;
    }
    result.push_back(to);
    return result;
}

} // namespace

QPainterPath curvePath(const BSpline2& curve, double from, double to, const std::function<Vec2(const Vec2&)>& place)
{
    const auto placed = [&](const Vec2& p) { return toPoint(place(p)); };
    const std::vector<double> breaks = breaksBetween(curve, from, to);
    QPainterPath path(placed(curve.at(curve.wrapped(from))));
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        if (curve.degree() == 1) {
            path.lineTo(placed(curve.at(curve.wrapped(breaks[i + 1]))));
            continue;
        }
        // The Taylor expansion at the piece's middle is the whole piece; in Bezier form it is this. (At its ends
        // rounding may find the neighbour.)
        const double t = curve.wrapped((breaks[i] + breaks[i + 1]) / 2), h = (breaks[i + 1] - breaks[i]) / 2;
        const Vec2 middle = curve.at(t), first = curve.derivative(t) * h;
        const Vec2 second = curve.derivative(t, 2) * (h * h / 2);
        const Vec2 third = curve.degree() == 3 ? Vec2(curve.derivative(t, 3) * (h * h * h / 6)) : Vec2::Zero();
        path.cubicTo(placed(middle - first / 3 - second / 3 + third),
                     placed(middle + first / 3 - second / 3 - third), placed(middle + first + second + third));
    }
    return path;
}

QPainterPath curvePath(const BSpline2& curve, const std::function<Vec2(const Vec2&)>& place)
{
    if (curve.empty())
        return {};
    QPainterPath path = curvePath(curve, curve.domainStart(), curve.domainEnd(), place);
    if (curve.closed())
        path.closeSubpath();
    return path;
}

} // namespace bolster
