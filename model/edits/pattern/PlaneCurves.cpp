#include "PlaneCurves.h"

#include "BezierPieces.h"

#include <algorithm>
#include <cmath>

namespace bolster::edits {

std::optional<BSpline2> mapped(const BSpline2& curve, const Map2& map)
{
    std::vector<Vec2> points = curve.points();
    for (Vec2& point : points)
        point = map * point;
    if (BSpline2::problem(curve.degree(), curve.closed(), points, curve.knots()))
        return std::nullopt;
    return curve.withPoints(std::move(points));
}

namespace {

/// The inner control points of a piece as a cubic.
std::array<Vec2, 2> innerPoints(const BezierPiece<2>& piece)
{
    const auto& p = piece.points;
    if (piece.degree == 1)
        return {(2 * p[0] + p[1]) / 3, (p[0] + 2 * p[1]) / 3};
    if (piece.degree == 2)
        return {(p[0] + 2 * p[1]) / 3, (2 * p[1] + p[2]) / 3};
    return {p[1], p[2]};
}

} // namespace

BSpline2 raisedToCubic(const BSpline2& curve)
{
    if (curve.degree() == 3)
        return curve;
    std::vector<Vec2> points;
    for (const BezierPiece<2>& piece : bezierPieces(curve)) {
        const auto [a, b] = innerPoints(piece);
        points.insert(points.end(), {piece.front(), a, b});
    }
    const std::vector<double> breaks = curve.breaks();
    const int atStart = curve.closed() ? 2 : 4;
    std::vector<double> knots(static_cast<std::size_t>(atStart), breaks.front());
    for (std::size_t i = 1; i + 1 < breaks.size(); ++i)
        knots.insert(knots.end(), 3, breaks[i]);
    knots.insert(knots.end(), static_cast<std::size_t>(atStart), breaks.back());
    if (!curve.closed())
        points.push_back(curve.points().back());
    return BSpline2(3, curve.closed(), std::move(points), std::move(knots));
}

BSpline2 polyline(const std::vector<Vec2>& points, int degree, double start, double speed)
{
    std::vector<double> knots = {start, start};
    for (std::size_t i = 1; i < points.size(); ++i)
        knots.push_back(knots.back() + (points[i] - points[i - 1]).norm() / speed);
    knots.push_back(knots.back());
    const BSpline2 line(1, false, points, std::move(knots));
    if (degree == 1)
        return line;
    const BSpline2 cubic = raisedToCubic(line);
    if (degree == 3)
        return cubic;
    // Quadratic: a point in the middle of each edge.
    std::vector<Vec2> middles = {points.front()};
    std::vector<double> doubled(3, start);
    for (std::size_t i = 1; i < points.size(); ++i) {
        middles.insert(middles.end(), {(points[i - 1] + points[i]) / 2, points[i]});
        doubled.insert(doubled.end(), i + 1 < points.size() ? 2 : 3, line.knots()[i + 1]);
    }
    return BSpline2(2, false, std::move(middles), std::move(doubled));
}

namespace {

template <int Dim>
BSpline<Dim> inOneRing(const std::vector<BSpline<Dim>>& curves, std::vector<double>* starts)
{
    const int degree = curves.front().degree();
    const int before = (degree + 1) / 2; // of a clamped curve's knots: those that belong to the curve before
    std::vector<typename BSpline<Dim>::Point> points;
    std::vector<double> knots;
    double base = 0;
    for (const BSpline<Dim>& curve : curves) {
        if (starts)
            starts->push_back(base);
        for (int i = 0; i + 1 < curve.pointCount(); ++i) {
            points.push_back(curve.points()[static_cast<std::size_t>(i)]);
            knots.push_back(curve.knots()[static_cast<std::size_t>(i + before)] - curve.domainStart() + base);
        }
        base += curve.domainEnd() - curve.domainStart();
        // The knots at the joint must be equal, whatever the rounding.
        for (auto knot = knots.rbegin(); knot != knots.rend() && *knot > base - 1e-12 * base; ++knot)
            *knot = base;
    }
    knots.push_back(base);
    return BSpline<Dim>(degree, true, std::move(points), std::move(knots));
}

} // namespace

BSpline2 joined(const std::vector<BSpline2>& curves, std::vector<double>* starts)
{
    return inOneRing(curves, starts);
}

BSpline2 closedCurve(const BSpline2& curve)
{
    return inOneRing<2>({curve}, nullptr);
}

BSpline3 closedCurve(const BSpline3& curve)
{
    return inOneRing<3>({curve}, nullptr);
}

BSpline2 beginningAt(const BSpline2& curve, double start)
{
    std::vector<double> knots = curve.knots();
    for (double& knot : knots)
        knot += start - curve.domainStart();
    return {curve.degree(), true, curve.points(), std::move(knots)};
}

double inFirstTurn(const BSpline2& curve, double t)
{
    return t - curve.period() * std::floor((t - curve.domainStart()) / curve.period());
}

bool isCorner(const BSpline2& curve, int i)
{
    const double t = curve.parameterOfPoint(i);
    const std::vector<double> corners = curve.corners();
    return std::find(corners.begin(), corners.end(), t) != corners.end();
}

} // namespace bolster::edits
