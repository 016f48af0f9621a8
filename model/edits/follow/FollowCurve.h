// How a curve follows its mirror twin, point by point. Private to the library.
#pragma once

#include "Twins.h"

#include <algorithm>
#include <cmath>

namespace bolster::edits {

template <int Dim>
using Curve = BSpline<Dim>;

/// One curve of two twins, before and after the edit.
template <int Dim>
struct CurvePair {
    Curve<Dim> before[2];
    Curve<Dim> now[2];
    std::set<int> released; ///< of this curve, numbered from 0
};

template <int Dim>
bool sameKind(const Curve<Dim>& a, const Curve<Dim>& b)
{
    return a.degree() == b.degree() && a.closed() == b.closed() && a.knots() == b.knots();
}

template <int Dim>
bool moved(const CurvePair<Dim>& pair, int side, int point)
{
    const auto i = static_cast<std::size_t>(point);
    return pair.now[side].points()[i] != pair.before[side].points()[i];
}

template <int Dim>
bool allMoved(const CurvePair<Dim>& pair, int side)
{
    for (int i = 0; i < pair.now[side].pointCount(); ++i)
        if (!moved(pair, side, i))
            return false;
    return true;
}

template <int Dim>
Curve<Dim> withPointsIfValid(const Curve<Dim>& curve, std::vector<typename Curve<Dim>::Point> points)
{
    const bool valid = !Curve<Dim>::problem(curve.degree(), curve.closed(), points, curve.knots());
    return valid ? curve.withPoints(std::move(points)) : curve;
}

/// Points that moved take along those of the other side.
template <int Dim, class Mirror>
void followPoints(CurvePair<Dim>& pair, const Mirror& mirror)
{
    std::vector<typename Curve<Dim>::Point> points[2] = {pair.now[0].points(), pair.now[1].points()};
    const bool whole[2] = {allMoved(pair, 0), allMoved(pair, 1)};
    for (int i = 0; i < pair.now[0].pointCount(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const bool first = moved(pair, 0, i);
        const bool second = moved(pair, 1, i);
        const int from = first ? 0 : 1;
        if (!first && !second)
            continue;
        auto& other = points[1 - from][at];
        const auto place = mirror(points[from][at]);
        if (!pair.released.contains(i)) {
            if ((place - other).norm() > mirrorTolerance)
                other = place;
        } else if (whole[from] && !whole[1 - from] && !(first && second)) {
            other += place - mirror(pair.before[from].points()[at]);
        }
    }
    for (const int side : {0, 1})
        pair.now[side] = withPointsIfValid(pair.now[side], std::move(points[side]));
}

/// The curve `before` with the knots that `now` has more, if that is all the difference; else nothing.
template <int Dim>
std::optional<Curve<Dim>> withSameKnots(const Curve<Dim>& other, const Curve<Dim>& before, const Curve<Dim>& now)
{
    std::vector<double> added;
    std::set_difference(now.knots().begin(), now.knots().end(), before.knots().begin(), before.knots().end(),
                        std::back_inserter(added));
    if (!sameKind(other, before) || added.empty() || now.pointCount() <= before.pointCount())
        return std::nullopt;
    Curve<Dim> check = before;
    Curve<Dim> result = other;
    for (const double knot : added) {
        check = check.withKnot(knot);
        result = result.withKnot(knot);
    }
    return check == now && sameKind(result, now) ? std::optional(result) : std::nullopt;
}

/// Where the released points of a curve are found again after its points changed in number, by their parameters.
template <int Dim>
std::map<int, int> foundAgain(const std::set<int>& released, const Curve<Dim>& before, const Curve<Dim>& now)
{
    std::map<int, int> result; // new index by old one
    const bool same = sameKind(before, now);
    for (const int old : released) {
        if (old >= before.pointCount())
            continue;
        const double parameter = before.parameterOfPoint(old);
        if (same)
            result.emplace(old, old);
        for (int i = 0; i < now.pointCount() && !same; ++i)
            if (std::abs(now.parameterOfPoint(i) - parameter) <= 1e-9 * before.period())
                result.emplace(old, i);
    }
    return result;
}

/// The side `to` gets the points that the other one has now.
template <int Dim, class Mirror>
void followShape(CurvePair<Dim>& pair, int to, const Mirror& mirror)
{
    using Point = typename Curve<Dim>::Point;
    const Curve<Dim>& before = pair.before[1 - to];
    const Curve<Dim>& now = pair.now[1 - to];
    if (now.empty()) { // a handle without a target
        pair.now[to] = now;
        pair.released.clear();
        return;
    }
    std::vector<Point> points;
    for (const Point& point : now.points())
        points.push_back(mirror(point));
    const std::map<int, int> kept = foundAgain(pair.released, before, now);
    std::set<int> released;
    if (const auto refined = pair.released.empty() ? std::nullopt : withSameKnots(pair.before[to], before, now)) {
        // The other one keeps its own shape where it is released; what that mixes is an exception, too.
        for (std::size_t i = 0; i < points.size(); ++i) {
            if ((refined->points()[i] - points[i]).norm() <= mirrorTolerance)
                continue;
            points[i] = refined->points()[i];
            released.insert(static_cast<int>(i));
        }
    } else {
        for (const auto& [old, found] : kept)
            if (old < pair.before[to].pointCount())
                points[static_cast<std::size_t>(found)] = pair.before[to].points()[static_cast<std::size_t>(old)];
    }
    for (const auto& [old, found] : kept)
        released.insert(found);
    if (Curve<Dim>::problem(now.degree(), now.closed(), points, now.knots()))
        return;
    pair.now[to] = now.withPoints(std::move(points));
    pair.released = std::move(released);
}

template <int Dim, class Mirror>
bool alike(const CurvePair<Dim>& pair, const Mirror& mirror)
{
    if (!sameKind(pair.now[0], pair.now[1]))
        return false;
    for (int i = 0; i < pair.now[0].pointCount(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (!pair.released.contains(i) &&
            (mirror(pair.now[0].points()[at]) - pair.now[1].points()[at]).norm() > mirrorTolerance)
            return false;
    }
    return true;
}

/// `anew`: the second is not yet what the first makes of it, even if neither changed.
template <int Dim, class Mirror>
void followCurve(CurvePair<Dim>& pair, bool anew, const Mirror& mirror)
{
    const bool changed[2] = {!(pair.before[0] == pair.now[0]), !(pair.before[1] == pair.now[1])};
    if (!(changed[0] || changed[1] || anew) || alike(pair, mirror))
        return;
    const bool kept[2] = {sameKind(pair.before[0], pair.now[0]), sameKind(pair.before[1], pair.now[1])};
    const bool secondLeads = (changed[1] && !changed[0]) || (kept[0] && !kept[1]);
    if (kept[0] && kept[1] && sameKind(pair.now[0], pair.now[1]) && !anew)
        followPoints(pair, mirror);
    else
        followShape(pair, secondLeads ? 0 : 1, mirror);
}

} // namespace bolster::edits
