// The rules that a curve must obey.
#include "BSpline.h"

#include "SplineKnots.h"

#include <cmath>

namespace bolster {

template <int Dim>
std::optional<Message> BSpline<Dim>::problem(int degree, bool closed, const std::vector<Point>& points,
                                             const std::vector<double>& knots)
{
    const int count = static_cast<int>(points.size());
    const int fewest = closed ? 3 : degree + 1;
    if (degree < 1 || degree > 3)
        return Message{QT_TRANSLATE_NOOP("Message", "the degree must be 1, 2 or 3, not %1"),
                       {std::to_string(degree)}};
    if (count < fewest)
        return Message{closed
                           ? QT_TRANSLATE_NOOP("Message", "a closed curve needs at least %1 points, not %2")
                           : QT_TRANSLATE_NOOP("Message", "an open curve of this degree needs at least %1 points, "
                                                          "not %2"),
                       {std::to_string(fewest), std::to_string(count)}};
    for (int i = 0; i < count; ++i)
        if (!(points[static_cast<std::size_t>(i)].cwiseAbs().maxCoeff() <= largestCoordinate) ||
            !points[static_cast<std::size_t>(i)].allFinite())
            return Message{QT_TRANSLATE_NOOP("Message", "point %1 is no number or beyond 1e7 mm"),
                           {std::to_string(i)}};
    return knots.empty() ? std::nullopt : spline::knotProblem(degree, closed, count, knots);
}

template <int Dim>
std::optional<Message> BSpline<Dim>::cornerProblem(int degree, bool closed, int pointCount,
                                                   const std::vector<int>& corners)
{
    if (degree != 3 || !closed)
        return Message{QT_TRANSLATE_NOOP("Message", "corners belong to closed curves of degree 3 only")};
    if (corners.empty())
        return Message{QT_TRANSLATE_NOOP("Message", "the list of corners is empty; leave it out")};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i] < 0 || corners[i] >= pointCount)
            return Message{
                QT_TRANSLATE_NOOP("Message", "corner %1 does not exist; the points are numbered 0 to %2"),
                {std::to_string(corners[i]), std::to_string(pointCount - 1)}};
        if (i > 0 && corners[i] <= corners[i - 1])
            return Message{QT_TRANSLATE_NOOP("Message", "the corners must increase, but %1 follows %2"),
                           {std::to_string(corners[i]), std::to_string(corners[i - 1])}};
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const bool last = i + 1 == corners.size();
        const int next = last ? corners.front() + pointCount : corners[i + 1];
        if (next - corners[i] < 3)
            return Message{QT_TRANSLATE_NOOP("Message",
                                             "there must be at least two points between the corners %1 and "
                                             "%2 (a straight edge: at its thirds)"),
                           {std::to_string(corners[i]), std::to_string(next % pointCount)}};
    }
    return std::nullopt;
}

template std::optional<Message> BSpline<2>::problem(int, bool, const std::vector<Vec2>&,
                                                    const std::vector<double>&);
template std::optional<Message> BSpline<3>::problem(int, bool, const std::vector<Vec3>&,
                                                    const std::vector<double>&);
template std::optional<Message> BSpline<2>::cornerProblem(int, bool, int, const std::vector<int>&);
template std::optional<Message> BSpline<3>::cornerProblem(int, bool, int, const std::vector<int>&);

} // namespace bolster
