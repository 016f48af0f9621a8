#include "OutlineFit.h"

#include "CurveFit.h"
#include "PlaneCurves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double surelyCorner = 35 * degree;
constexpr double leastKink = 1.5 * degree;
constexpr double roundedTo = 0.03;        // mm: what programs write
constexpr double straightShare = 6;       // an edge that is so much longer than the next is no chord of a curve
constexpr double shortestLine = 15;       // mm: of those
constexpr double coarsest = 0.6;          // mm: farther from its curve nobody writes a polygon
constexpr double straight = 0.01;         // mm
constexpr std::size_t mostSamples = 1200; // of one curve between two corners
constexpr std::size_t fewestSamples = 96;

/// Turning angles and lengths along a line.
class Bends {
public:
    explicit Bends(const Contour& line)
        : m_line(line)
        , m_count(line.points.size())
    {}

    std::size_t count() const { return m_count; }
    const Vec2& at(std::size_t i) const { return m_line.points[i % m_count].at; }
    double length(std::size_t edge) const { return (at(edge + 1) - at(edge)).norm(); }
    bool hasBend(std::size_t i) const { return m_line.closed || (i > 0 && i + 1 < m_count); }
    /// Left is positive; 0 at the ends of an open line.
    double angle(std::size_t i) const
    {
        if (!hasBend(i))
            return 0;
        const Vec2 before = at(i) - at(i + m_count - 1), after = at(i + 1) - at(i);
        return std::atan2(cross(before, after), before.dot(after));
    }

    bool isCorner(std::size_t i) const
    {
        return isSureCorner(i) || (m_line.points[i].bend != Bend::Smooth && isKink(i));
    }

private:
    /// Whatever the curve does beside it.
    bool isSureCorner(std::size_t i) const
    {
        const Bend bend = m_line.points[i].bend;
        if (!hasBend(i) || bend == Bend::Corner)
            return true;
        if (bend != Bend::Smooth && isStraightBeside(i))
            return true;
        const double turn = std::abs(angle(i));
        return bend != Bend::Smooth &&
               (turn > surelyCorner || std::min(length(i + m_count - 1), length(i)) * turn / 8 > coarsest);
    }

    /// A line that a curve goes on from stays a line: it has an end of its own, however smooth the joint is.
    bool isStraightBeside(std::size_t i) const
    {
        const double a = length(i + m_count - 1), b = length(i);
        return std::max(a, b) > shortestLine && std::max(a, b) > straightShare * std::min(a, b);
    }

    /// A joint that turns otherwise than the curve beside it makes one expect. Its neighbours are surprised as
    /// well, but less.
    bool isKink(std::size_t i) const
    {
        const std::size_t before = (i + m_count - 1) % m_count, after = (i + 1) % m_count;
        const double off = surprise(i);
        return off > 0 && (isSureCorner(after) || off >= surprise(after)) &&
               (isSureCorner(before) || off > surprise(before));
    }

    double surprise(std::size_t i) const
    {
        const std::size_t before = (i + m_count - 1) % m_count, after = (i + 1) % m_count;
        const double a = length(before), b = length(i);
        double curvature = 0;
        int sides = 0;
        if (!isSureCorner(before)) {
            curvature += 2 * angle(before) / (length(before + m_count - 1) + a);
            ++sides;
        }
        if (!isSureCorner(after)) {
            curvature += 2 * angle(after) / (b + length(after));
            ++sides;
        }
        const double expected = sides == 0 ? 0 : curvature / sides * (std::min(a, 2 * b) + std::min(b, 2 * a)) / 2;
        const double off = std::abs(angle(i) - expected);
        return off > leastKink + roundedTo / std::min(a, b) && off > 1.3 * std::abs(expected) ? off : 0;
    }

    const Contour& m_line;
    std::size_t m_count;
};

/// From one corner to the next: vertices first .. last of the line, last >= first, around the end of a closed one.
class StretchFit {
public:
    StretchFit(const Bends& bends, std::size_t first, std::size_t last, double tolerance)
        : m_bends(bends)
        , m_first(first)
        , m_last(last)
        , m_tolerance(tolerance)
    {}

    bool isStraight() const
    {
        const Vec2 a = m_bends.at(m_first), way = m_bends.at(m_last) - a;
        const double length = way.norm();
        for (std::size_t i = m_first + 1; i < m_last; ++i) {
            const Vec2 off = m_bends.at(i) - a;
            if (length < 1e-9 || std::abs(cross(way, off)) / length > straight || off.dot(way) < 0 ||
                off.dot(way) > length * length)
                return false;
        }
        return true;
    }

    BSpline2 line() const { return edits::polyline({m_bends.at(m_first), m_bends.at(m_last)}, 3, 0, 1); }

    /// `closed`: a whole line without a corner, first and last being the same.
    BSpline2 curve(bool closed) const
    {
        CurveSamples samples;
        samples.closed = closed;
        double at = 0, whole = 0;
        for (std::size_t i = m_first; i < m_last; ++i)
            whole += m_bends.length(i);
        const std::size_t stride = std::max<std::size_t>(1, (m_last - m_first) / mostSamples);
        const double step = whole / static_cast<double>(fewestSamples);
        for (std::size_t i = m_first; i < m_last; ++i) {
            if ((i - m_first) % stride == 0)
                add(samples, m_bends.at(i), at);
            const auto parts = static_cast<int>(std::clamp(std::ceil(m_bends.length(i) / step), 2.0, 64.0));
            for (int k = 1; k < parts; ++k)
                add(samples, between(i, static_cast<double>(k) / parts), at + m_bends.length(i) * k / parts);
            at += m_bends.length(i);
        }
        if (!closed)
            add(samples, m_bends.at(m_last), at);
        samples.end = at;
        const BSpline3 fitted = fitCurve(samples, m_tolerance);
        std::vector<Vec2> points;
        for (const Vec3& point : fitted.points())
            points.emplace_back(point.head<2>());
        return {fitted.degree(), fitted.closed(), std::move(points), fitted.knots()};
    }

private:
    static void add(CurveSamples& samples, const Vec2& at, double parameter)
    {
        samples.points.emplace_back(at.x(), at.y(), 0);
        samples.parameters.push_back(parameter);
    }

    double bendAt(std::size_t i) const
    {
        return i > m_first && i < m_last ? m_bends.angle(i % m_bends.count()) : 0;
    }

    /// On an arc over the edge that turns as much as its ends do: the edge is a chord of the curve, unless it is
    /// straight where it touches one.
    Vec2 between(std::size_t edge, double share) const
    {
        double a = bendAt(edge), b = bendAt(edge + 1);
        const double length = m_bends.length(edge);
        if (edge == m_first && length <= 1.5 * m_bends.length(edge + 1))
            a = b;
        if (edge + 1 == m_last && m_last - m_first > 1 &&
            length <= 1.5 * m_bends.length(edge + m_bends.count() - 1))
            b = a;
        const double turn = a * b > 0 ? std::copysign(std::min(std::abs(a), std::abs(b)), a) : 0;
        const Vec2 way = m_bends.at(edge + 1) - m_bends.at(edge);
        const Vec2 right(way.y(), -way.x());
        const double height = turn / 8; // of the edge's length
        return m_bends.at(edge) + share * way + 4 * share * (1 - share) * height * right;
    }

    const Bends& m_bends;
    std::size_t m_first, m_last;
    double m_tolerance;
};

Contour withoutDoubles(const Contour& line)
{
    Contour result = line;
    result.points.clear();
    for (const DrawnPoint& point : line.points)
        if (result.points.empty() || (point.at - result.points.back().at).norm() > 1e-6)
            result.points.push_back(point);
    while (result.closed && result.points.size() > 1 &&
           (result.points.front().at - result.points.back().at).norm() <= 1e-6)
        result.points.pop_back();
    return result;
}

/// Clamped curves, each beginning where the one before ends, as one with corners at the joints.
BSpline2 openJoined(const std::vector<BSpline2>& curves)
{
    std::vector<Vec2> points{curves.front().points().front()};
    std::vector<double> knots(4, 0);
    double start = 0;
    for (const BSpline2& curve : curves) {
        points.insert(points.end(), curve.points().begin() + 1, curve.points().end());
        const double end = start + curve.domainEnd() - curve.domainStart();
        for (std::size_t k = 4; k + 4 < curve.knots().size(); ++k)
            knots.push_back(start + curve.knots()[k] - curve.domainStart());
        knots.insert(knots.end(), 3, end);
        start = end;
    }
    knots.push_back(start);
    return {3, false, std::move(points), std::move(knots)};
}

std::optional<BSpline2> curveThrough(const Contour& line, double tolerance)
{
    const Bends bends(line);
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < bends.count(); ++i)
        if (bends.isCorner(i))
            corners.push_back(i);
    if (corners.empty())
        return StretchFit(bends, 0, bends.count(), tolerance).curve(true);
    if (line.closed)
        corners.push_back(corners.front() + bends.count());
    std::vector<StretchFit> stretches;
    for (std::size_t k = 0; k + 1 < corners.size(); ++k)
        stretches.emplace_back(bends, corners[k], corners[k + 1], tolerance);
    if (stretches.size() >= (line.closed ? 3 : 1) && std::ranges::all_of(stretches, &StretchFit::isStraight)) {
        std::vector<Vec2> points;
        for (std::size_t k = 0; k + (line.closed ? 1 : 0) < corners.size(); ++k)
            points.push_back(bends.at(corners[k]));
        return BSpline2(1, line.closed, std::move(points));
    }
    std::vector<BSpline2> curves;
    for (const StretchFit& stretch : stretches)
        curves.push_back(stretch.isStraight() ? stretch.line() : stretch.curve(false));
    if (line.closed)
        return edits::joined(curves, nullptr);
    return openJoined(curves);
}

} // namespace

std::optional<BSpline2> fittedCurve(const Contour& line, double tolerance)
{
    const Contour clean = withoutDoubles(line);
    if (clean.points.size() < (line.closed ? 3u : 2u))
        return std::nullopt;
    try {
        return curveThrough(clean, tolerance);
    } catch (const std::invalid_argument&) { // what BSpline cannot be made of
        return std::nullopt;
    }
}

namespace {

/// The directions from one point in which a straight line passes the points after it.
class DirectionWedge {
public:
    bool holds(const Vec2& way) const { return !m_any || (cross(m_low, way) >= 0 && cross(way, m_high) >= 0); }

    void narrow(const Vec2& way, double tolerance)
    {
        const double length = way.norm();
        if (length <= tolerance)
            return;
        const double half = std::asin(tolerance / length);
        const Vec2 low = Eigen::Rotation2Dd(-half) * way, high = Eigen::Rotation2Dd(half) * way;
        m_low = m_any && cross(m_low, low) < 0 ? m_low : low;
        m_high = m_any && cross(high, m_high) < 0 ? m_high : high;
        m_any = true;
    }

private:
    bool m_any = false;
    Vec2 m_low = Vec2::Zero(), m_high = Vec2::Zero();
};

} // namespace

Contour thinned(const Contour& line, double tolerance)
{
    Contour result = line;
    const std::size_t count = line.points.size();
    if (count < 3)
        return result;
    result.points = {line.points.front()};
    DirectionWedge wedge;
    std::size_t anchor = 0;
    const auto wayTo = [&](std::size_t i) -> Vec2 { return line.points[i % count].at - line.points[anchor].at; };
    for (std::size_t i = 1; i < count + (line.closed ? 1 : 0); ++i) {
        const bool corner = i - 1 > anchor && line.points[i - 1].bend == Bend::Corner;
        if (i - 1 > anchor && (corner || (wayTo(i).norm() > tolerance && !wedge.holds(wayTo(i))))) {
            anchor = i - 1;
            result.points.push_back(line.points[anchor]);
            wedge = {};
        }
        wedge.narrow(wayTo(i), tolerance);
    }
    if (!line.closed)
        result.points.push_back(line.points.back());
    return result;
}

std::optional<FittedLine> fittedLine(const Contour& line)
{
    const auto fits = [](const std::optional<BSpline2>& curve) {
        return curve && curve->pointCount() <= mostCurvePoints;
    };
    if (auto curve = fittedCurve(line); !curve || fits(curve))
        return curve ? std::optional(FittedLine{std::move(*curve), 0}) : std::nullopt;
    for (const double tolerance : {0.05, 0.1, 0.2, 0.5})
        if (auto curve = fittedCurve(thinned(line, tolerance / 2), tolerance / 2); fits(curve))
            return FittedLine{std::move(*curve), tolerance};
    return std::nullopt;
}

} // namespace bolster
