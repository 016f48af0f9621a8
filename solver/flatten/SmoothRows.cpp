#include "SmoothRows.h"

#include "PlaneCurves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr int samplesOfEdge = 4;                 // for fitting
constexpr double bendsAlike = 3, muchLonger = 6; // times as long as the edge beside it
constexpr double mostTimes = 20;                 // as many samples as an edge of usual length has

/// Of a row; `at`: how far along its points are, mm.
double medianEdge(const std::vector<double>& at)
{
    std::vector<double> lengths;
    for (std::size_t i = 1; i < at.size(); ++i)
        lengths.push_back(at[i] - at[i - 1]);
    const auto middle = lengths.begin() + std::ssize(lengths) / 2;
    std::ranges::nth_element(lengths, middle);
    return middle == lengths.end() ? 0 : *middle;
}

template <class Point>
bool isStraight(const std::vector<Point>& row, double tolerance)
{
    const Point way = row.back() - row.front();
    const double length = way.norm();
    return std::ranges::all_of(row, [&](const Point& point) {
        const Point off = point - row.front();
        const double along = length > 0 ? off.dot(way) / length : 0;
        return along >= -tolerance && along <= length + tolerance &&
               (off - along * way / std::max(length, 1e-9)).norm() <= tolerance;
    });
}

} // namespace

template <class Point>
double turnAt(const Point& before, const Point& at, const Point& after)
{
    const Point in = at - before, out = after - at;
    const double both = in.norm() * out.norm();
    return both > 0 ? std::acos(std::clamp(in.dot(out) / both, -1.0, 1.0)) * 180 / std::numbers::pi : 0;
}

template <class Point>
double roundedBy(const Point& before, const Point& at, const Point& after)
{
    const double one = (at - before).norm(), other = (after - at).norm();
    const bool fromLine = std::max(one, other) > muchLonger * std::min(one, other); // which stays one
    const double length = fromLine ? std::min(one, other) : std::max(one, other);
    return length / 2 * std::tan(turnAt(before, at, after) / 4 * std::numbers::pi / 180);
}

template <class Point>
std::vector<double> lengthsAlong(const std::vector<Point>& row)
{
    std::vector<double> at(row.size(), 0);
    for (std::size_t i = 1; i < row.size(); ++i)
        at[i] = at[i - 1] + (row[i] - row[i - 1]).norm();
    return at;
}

template <class Point>
CurveSamples smoothSamples(const std::vector<Point>& row, const std::vector<double>& at)
{
    const std::size_t count = row.size();
    const auto slope = [&](std::size_t i) {
        return Point((row[i + 1] - row[i]) / std::max(at[i + 1] - at[i], 1e-9));
    };
    std::vector<Point> tangents(count);
    for (std::size_t i = 1; i + 1 < count; ++i) {
        const double before = at[i] - at[i - 1], after = at[i + 1] - at[i];
        const Point ofParabola = (slope(i - 1) * after + slope(i) * before) / std::max(before + after, 1e-9);
        const double times = std::max(before, after) / std::max(std::min(before, after), 1e-9);
        const double straight = std::clamp((times - bendsAlike) / (muchLonger - bendsAlike), 0.0, 1.0);
        tangents[i] = (1 - straight) * ofParabola + straight * (before > after ? slope(i - 1) : slope(i));
    }
    tangents.front() = count > 2 ? Point(2 * slope(0) - tangents[1]) : slope(0);
    tangents.back() = count > 2 ? Point(2 * slope(count - 2) - tangents[count - 2]) : slope(0);
    CurveSamples samples;
    const auto add = [&](const Point& point, double parameter) {
        Vec3 place = Vec3::Zero();
        place.template head<Point::SizeAtCompileTime>() = point;
        samples.points.push_back(place);
        samples.parameters.push_back(parameter);
    };
    const double usual = medianEdge(at);
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double length = at[i + 1] - at[i];
        add(row[i], at[i]);
        const double times = usual > 0 ? std::clamp(length / usual, 1.0, mostTimes) : 1;
        const int samplesHere = static_cast<int>(samplesOfEdge * times); // between them a curve may go anywhere
        for (int k = 1; k < samplesHere; ++k) {
            const double t = static_cast<double>(k) / samplesHere;
            const double h01 = t * t * (3 - 2 * t), h10 = t * (1 - t) * (1 - t), h11 = -t * t * (1 - t);
            add((1 - h01) * row[i] + h01 * row[i + 1] + length * (h10 * tangents[i] + h11 * tangents[i + 1]),
                at[i] + t * length);
        }
    }
    add(row.back(), at.back());
    samples.end = at.back();
    return samples;
}

BSpline2 curveOf(const std::vector<Vec2>& row, double tolerance)
{
    if (isStraight(row, tolerance / 4))
        return edits::polyline({row.front(), row.back()}, 3, 0, 1);
    const BSpline3 fitted = fitCurve(smoothSamples(row, lengthsAlong(row)), tolerance);
    std::vector<Vec2> points;
    for (const Vec3& point : fitted.points())
        points.emplace_back(point.head<2>());
    return {fitted.degree(), false, std::move(points), fitted.knots()};
}

template double turnAt(const Vec2&, const Vec2&, const Vec2&);
template double turnAt(const Vec3&, const Vec3&, const Vec3&);
template double roundedBy(const Vec2&, const Vec2&, const Vec2&);
template double roundedBy(const Vec3&, const Vec3&, const Vec3&);
template std::vector<double> lengthsAlong(const std::vector<Vec2>&);
template std::vector<double> lengthsAlong(const std::vector<Vec3>&);
template CurveSamples smoothSamples(const std::vector<Vec2>&, const std::vector<double>&);
template CurveSamples smoothSamples(const std::vector<Vec3>&, const std::vector<double>&);

} // namespace bolster
