#include "LengthEdits.h"

#include "ArcLength.h"
#include "EditHelpers.h"

#include <cmath>

namespace bolster::edits {

namespace {

constexpr double shortestWay = 1e-3; // mm
constexpr double longestWay = 1e6;   // mm
constexpr double exactness = 1e-9;   // of the length

/// From one control point on to another one.
struct Way {
    int from = 0;
    int to = 0;
};

std::optional<Way> wayBetween(const BSpline2* curve, int a, int b)
{
    const auto exists = [&](int i) { return i >= 0 && i < curve->pointCount(); };
    if (!curve || curve->empty() || a == b || !exists(a) || !exists(b))
        return std::nullopt;
    if (!curve->closed())
        return Way{std::min(a, b), std::max(a, b)};
    const ArcLength2 length(*curve);
    const double ta = curve->parameterOfPoint(a), tb = curve->parameterOfPoint(b);
    const double there = length.between(ta, tb > ta ? tb : tb + curve->period());
    return 2 * there <= length.total() * (1 + exactness) ? Way{a, b} : Way{b, a};
}

double lengthOfWay(const BSpline2& curve, const Way& way)
{
    const double start = curve.parameterOfPoint(way.from), end = curve.parameterOfPoint(way.to);
    return ArcLength2(curve).between(start, end > start || !curve.closed() ? end : end + curve.period());
}

/// Nothing when a point would leave the sensible range.
std::optional<BSpline2> scaled(const BSpline2& curve, const Way& way, double factor)
{
    std::vector<Vec2> points = curve.points();
    const Vec2 start = points[static_cast<std::size_t>(way.from)];
    for (int i = way.from; i != way.to;) {
        i = (i + 1) % curve.pointCount();
        Vec2& point = points[static_cast<std::size_t>(i)];
        point = start + factor * (point - start);
    }
    if (BSpline2::problem(curve.degree(), curve.closed(), points, curve.knots()))
        return std::nullopt;
    return curve.withPoints(std::move(points));
}

} // namespace

double lengthBetween(const Design& design, ElementId id, int pointA, int pointB)
{
    const BSpline2* curve = curveInPattern(design, id);
    const std::optional<Way> way = wayBetween(curve, pointA, pointB);
    return way ? lengthOfWay(*curve, *way) : 0;
}

Edit setLengthBetween(const Design& design, ElementId id, int pointA, int pointB, double length)
{
    const BSpline2* curve = curveInPattern(design, id);
    const std::optional<Way> way = wayBetween(curve, pointA, pointB);
    if (!way || !(length >= shortestWay && length <= longestWay))
        return {};
    // Between corners the first step is exact; a smooth end bends with what lies beyond it.
    double factor = 1;
    std::optional<BSpline2> changed = *curve;
    for (int step = 0; step < 60; ++step) {
        const double now = lengthOfWay(*changed, *way);
        if (std::abs(now - length) <= exactness * length)
            return replaceElement(
                design, id, withPlaneCurve(*design.element(id), *changed),
                {QT_TRANSLATE_NOOP("Message", "Change the length of a stretch of %1"), {displayName(design, id)}});
        if (!(now > 0) || !((factor *= length / now) > 0))
            break;
        changed = scaled(*curve, *way, factor);
        if (!changed)
            break;
    }
    return {};
}

} // namespace bolster::edits
