#include "CoverPath.h"

#include "CurveFit.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double step = 4;        // mm between points of a path, but
constexpr double fewest = 12;     // this many between two given ones
constexpr double most = 100;      //
constexpr double tolerance = 0.5; // mm, of the curve
constexpr double apart = 1e-3;    // mm

std::vector<Vec3> distinct(const std::vector<Vec3>& points, bool closed)
{
    std::vector<Vec3> result;
    for (const Vec3& p : points)
        if (p.allFinite() && (result.empty() || (p - result.back()).norm() > apart))
            result.push_back(p);
    while (closed && result.size() > 1 && (result.back() - result.front()).norm() <= apart)
        result.pop_back();
    return result;
}

/// Between b and c, smooth through a, b, c, d (centripetal Catmull and Rom, as Barry and Goldman evaluate it).
Vec3 between(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double share)
{
    const auto after = [](double t, const Vec3& p, const Vec3& q) { return t + std::sqrt((q - p).norm()); };
    const double t0 = 0, t1 = after(t0, a, b), t2 = after(t1, b, c), t3 = after(t2, c, d);
    const double t = t1 + share * (t2 - t1);
    const auto mix = [t](const Vec3& p, const Vec3& q, double from, double to) -> Vec3 {
        return ((to - t) * p + (t - from) * q) / (to - from);
    };
    const Vec3 ab = mix(a, b, t0, t1), bc = mix(b, c, t1, t2), cd = mix(c, d, t2, t3);
    return mix(mix(ab, bc, t0, t2), mix(bc, cd, t1, t3), t1, t2);
}

} // namespace

CoverPath pathAlong(const std::vector<Vec3>& through, bool closed, bool smooth, const CoverFollow& follow)
{
    const std::vector<Vec3> points = distinct(through, closed);
    const auto count = static_cast<int>(points.size());
    if (count < (closed ? 3 : 2))
        return {};
    const auto at = [&](int i) -> Vec3 {
        if (closed)
            return points[static_cast<std::size_t>((i + count) % count)];
        if (i < 0)
            return 2 * points.front() - points[1];
        return i < count ? points[static_cast<std::size_t>(i)]
                         : Vec3(2 * points.back() - points[points.size() - 2]);
    };
    CoverPath path;
    path.closed = closed;
    path.smooth = smooth;
    const auto add = [&](const Vec3& p) {
        if (path.points.empty() || (p - path.points.back()).norm() > apart)
            path.points.push_back(p);
    };
    for (int i = 0; i < count; ++i) {
        add(at(i));
        if (!closed && i + 1 == count)
            break;
        if (!smooth)
            continue;
        const Vec3 b = at(i), c = at(i + 1);
        const double pieces = std::ceil(std::clamp((c - b).norm() / step, fewest, most));
        for (int k = 1; k < pieces; ++k) {
            const double share = k / pieces;
            const Vec3 p = between(at(i - 1), b, c, at(i + 2), share);
            if (const std::optional<Vec3> on = follow(p))
                add(*on);
            else
                add(p);
        }
    }
    return path;
}

std::optional<BSpline3> curveAlong(const CoverPath& path)
{
    if (path.points.size() < 2)
        return std::nullopt;
    if (!path.smooth)
        return BSpline3(1, path.closed, path.points);
    CurveSamples samples;
    samples.points = path.points;
    samples.closed = path.closed;
    samples.parameters = {0};
    for (std::size_t i = 1; i < path.points.size(); ++i)
        samples.parameters.push_back(samples.parameters.back() + (path.points[i] - path.points[i - 1]).norm());
    samples.start = 0;
    samples.end = samples.parameters.back();
    if (path.closed)
        samples.end += (path.points.front() - path.points.back()).norm();
    return fitCurve(samples, tolerance);
}

} // namespace bolster
