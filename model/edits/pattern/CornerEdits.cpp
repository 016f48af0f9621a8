#include "CornerEdits.h"

#include "ArcLength.h"
#include "EditHelpers.h"
#include "PlaneCurves.h"

#include <algorithm>

namespace bolster::edits {

namespace {

bool isEnd(const BSpline2& curve, int i)
{
    return !curve.closed() && (i == 0 || i == curve.pointCount() - 1);
}

/// A control point by the parameter at which it is found again when others have come or gone.
struct Place {
    double parameter = 0;
    Vec2 point = Vec2::Zero();
};

std::vector<Place> placesOf(const BSpline2& curve, std::span<const int> points)
{
    std::vector<Place> places;
    for (const int i : std::set<int>(points.begin(), points.end()))
        if (i >= 0 && i < curve.pointCount() && !isEnd(curve, i))
            places.push_back({curve.parameterOfPoint(i), curve.points()[static_cast<std::size_t>(i)]});
    return places;
}

BSpline2 withCorners(const BSpline2& curve, const std::vector<Place>& places)
{
    BSpline2 result = curve;
    for (const Place& place : places)
        for (int i = 0; i < curve.degree(); ++i)
            result = result.withKnot(place.parameter);
    for (const Place& place : places)
        result = result.withPoint(result.pointAt(place.parameter), place.point);
    return result;
}

/// The corner's knot becomes a simple one: of a cubic the two points next to the corner go, of a quadratic the
/// corner itself.
BSpline2 withoutCorner(const BSpline2& curve, int corner)
{
    const int count = curve.pointCount();
    const std::vector<int> gone = curve.degree() == 3 ? std::vector{corner - 1, corner + 1} : std::vector{corner};
    if (count - static_cast<int>(gone.size()) < (curve.closed() ? 3 : curve.degree() + 1))
        return curve;
    const auto isGone = [&](int i) {
        return std::any_of(gone.begin(), gone.end(), [&](int g) { return (g + count) % count == i; });
    };
    std::vector<Vec2> points;
    std::vector<double> knots;
    const int offset = curve.closed() ? 0 : (curve.degree() + 1) / 2; // knot i + offset belongs to point i
    for (int i = 0; i < offset; ++i)
        knots.push_back(curve.knots()[static_cast<std::size_t>(i)]);
    for (int i = 0; i < count; ++i) {
        if (isGone(i))
            continue;
        points.push_back(curve.points()[static_cast<std::size_t>(i)]);
        knots.push_back(curve.knots()[static_cast<std::size_t>(i + offset)]);
    }
    for (std::size_t i = static_cast<std::size_t>(count + offset); i < curve.knots().size(); ++i)
        knots.push_back(curve.knots()[i]);
    if (curve.closed() && knots.front() != curve.domainStart()) {
        // The knot at the start went, a copy at the end is left: it comes to the front, with its point.
        std::rotate(points.begin(), points.end() - 1, points.end());
        knots.insert(knots.begin(), curve.domainStart());
        knots.erase(knots.end() - 2);
    }
    if (BSpline2::problem(curve.degree(), curve.closed(), points, knots))
        return curve;
    return BSpline2(curve.degree(), curve.closed(), std::move(points), std::move(knots));
}

/// From point a on to point b, round the start if need be, corners at both.
BSpline2 straightBetween(const BSpline2& curve, int a, int b)
{
    const int count = curve.pointCount();
    const int steps = b > a ? b - a : b - a + count;
    const double start = curve.parameterOfPoint(a), period = curve.period();
    const auto ahead = [&](int i) {
        const double t = curve.parameterOfPoint(i) - start;
        return t < 0 ? t + period : t;
    };
    const ArcLength2 length(curve);
    // A polygon's points keep their distances; those of a smooth curve lie so that it runs evenly.
    const auto along = [&](int i) {
        return curve.degree() == 1 ? length.between(start, start + ahead(i)) : ahead(i);
    };
    const double whole = along(b);
    if (!(whole > 0))
        return curve; // all of them lie in one place
    std::vector<Vec2> points = curve.points();
    const Vec2 from = points[static_cast<std::size_t>(a)], to = points[static_cast<std::size_t>(b)];
    for (int k = 1; k < steps; ++k) {
        const int i = (a + k) % count;
        points[static_cast<std::size_t>(i)] = from + along(i) / whole * (to - from);
    }
    return curve.withPoints(std::move(points));
}

/// Of the two ways between the points the shorter one, as (from, to).
std::pair<int, int> shorterWay(const BSpline2& curve, int a, int b)
{
    if (!curve.closed())
        return std::minmax(a, b);
    const ArcLength2 length(curve);
    const double ta = curve.parameterOfPoint(a), tb = curve.parameterOfPoint(b);
    const double there = length.between(ta, tb > ta ? tb : tb + curve.period());
    return 2 * there <= length.total() * (1 + 1e-9) ? std::pair(a, b) : std::pair(b, a);
}

} // namespace

Edit makeCorners(const Design& design, ElementId id, std::span<const int> points)
{
    const BSpline2* curve = curveInPattern(design, id);
    if (!curve || curve->empty())
        return {};
    std::vector<Place> places = placesOf(*curve, points);
    const std::vector<double> corners = curve->corners();
    std::erase_if(places, [&](const Place& p) { return std::ranges::find(corners, p.parameter) != corners.end(); });
    const std::size_t added = places.size() * static_cast<std::size_t>(curve->degree());
    if (places.empty() || static_cast<std::size_t>(curve->pointCount()) + added > mostCurvePoints)
        return {};
    return replaceCurve(design, id, withCorners(*curve, places),
                        {QT_TRANSLATE_NOOP("Message", "Make a corner in %1"), {displayName(design, id)}});
}

Edit makeSmooth(const Design& design, ElementId id, std::span<const int> points)
{
    const BSpline2* curve = curveInPattern(design, id);
    if (!curve || curve->empty() || 3 * curve->pointCount() > mostCurvePoints)
        return {};
    std::vector<Place> places = placesOf(*curve, points);
    const std::vector<double> corners = curve->corners();
    std::erase_if(places, [&](const Place& p) { return std::ranges::find(corners, p.parameter) == corners.end(); });
    if (places.empty())
        return {};
    BSpline2 result = curve->degree() == 1 ? raisedToCubic(*curve) : *curve;
    for (const Place& place : places)
        result = withoutCorner(result, result.pointAt(place.parameter));
    return replaceCurve(design, id, std::move(result),
                        {QT_TRANSLATE_NOOP("Message", "Make %1 smooth"), {displayName(design, id)}});
}

Edit straighten(const Design& design, ElementId id, int pointA, int pointB)
{
    const BSpline2* curve = curveInPattern(design, id);
    const auto exists = [&](int i) { return i >= 0 && i < curve->pointCount(); };
    if (!curve || curve->empty() || pointA == pointB || !exists(pointA) || !exists(pointB) ||
        curve->pointCount() + 2 * curve->degree() > mostCurvePoints)
        return {};
    const auto [from, to] = shorterWay(*curve, pointA, pointB);
    const double start = curve->parameterOfPoint(from), end = curve->parameterOfPoint(to);
    const std::vector<int> ends = {from, to};
    const BSpline2 cornered = withCorners(*curve, placesOf(*curve, ends));
    BSpline2 straight = straightBetween(cornered, cornered.pointAt(start), cornered.pointAt(end));
    return replaceCurve(design, id, std::move(straight),
                        {QT_TRANSLATE_NOOP("Message", "Straighten a stretch of %1"), {displayName(design, id)}});
}

bool isCornerPoint(const Design& design, ElementId id, int point)
{
    const BSpline2* curve = curveInPattern(design, id);
    return curve && point >= 0 && point < curve->pointCount() && (isEnd(*curve, point) || isCorner(*curve, point));
}

} // namespace bolster::edits
