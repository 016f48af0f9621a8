#include "BSpline.h"

#include "SplineKnots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bolster {

template <int Dim>
BSpline<Dim>::BSpline(int degree, bool closed, std::vector<Point> points, std::vector<double> knots)
    : m_degree(degree)
    , m_closed(closed)
    , m_points(std::move(points))
    , m_knots(std::move(knots))
{
    if (const auto wrong = problem(m_degree, m_closed, m_points, m_knots))
        throw std::invalid_argument(wrong->english());
    if (m_knots.empty())
        m_knots = spline::defaultKnots(m_degree, m_closed, pointCount());
}

template <int Dim>
BSpline<Dim> BSpline<Dim>::withCorners(std::vector<Point> points, const std::vector<int>& corners)
{
    const int count = static_cast<int>(points.size());
    if (const auto wrong = cornerProblem(3, true, count, corners))
        throw std::invalid_argument(wrong->english());
    return BSpline(3, true, std::move(points), spline::cornerKnots(count, corners));
}

template <int Dim>
bool BSpline<Dim>::hasDefaultKnots() const
{
    return m_knots == spline::defaultKnots(m_degree, m_closed, pointCount());
}

template <int Dim>
std::optional<std::vector<int>> BSpline<Dim>::cornerIndices() const
{
    if (!m_closed || m_degree != 3)
        return std::nullopt;
    std::vector<int> indices;
    for (const double t : corners()) {
        const double index = t < 0 ? t + period() : std::fmod(t, period());
        if (index != std::floor(index) || index < 0 || index >= pointCount())
            return std::nullopt;
        indices.push_back(static_cast<int>(index));
    }
    std::sort(indices.begin(), indices.end());
    if (indices.empty() || cornerProblem(3, true, pointCount(), indices) ||
        m_knots != spline::cornerKnots(pointCount(), indices))
        return std::nullopt;
    return indices;
}

template <int Dim>
double BSpline<Dim>::domainStart() const
{
    return m_closed ? m_knots.front() : m_knots[static_cast<std::size_t>(m_degree)];
}

template <int Dim>
double BSpline<Dim>::domainEnd() const
{
    return m_knots[m_points.size()];
}

template <int Dim>
double BSpline<Dim>::wrapped(double t) const
{
    const double start = domainStart();
    const double end = domainEnd();
    if (!m_closed)
        return std::clamp(t, start, end);
    if (t >= start && t < end)
        return t;
    const double inside = t - (end - start) * std::floor((t - start) / (end - start));
    return inside >= start && inside < end ? inside : start; // rounding can reach the end
}

template <int Dim>
int BSpline<Dim>::pointIndex(int basis) const
{
    if (!m_closed)
        return basis;
    const int n = pointCount();
    const int index = (basis + shift()) % n;
    return index < 0 ? index + n : index;
}

template <int Dim>
double BSpline<Dim>::knot(int index) const
{
    const int n = pointCount();
    if (!m_closed || (index >= 0 && index <= n))
        return m_knots[static_cast<std::size_t>(index)];
    int turns = index < 0 ? -((n - 1 - index) / n) : index / n;
    const double value = m_knots[static_cast<std::size_t>(index - turns * n)];
    if (value != m_knots.front() && value != m_knots.back())
        return value + turns * period();
    // Knots at the start, all equal in spite of rounding.
    if (value == m_knots.back())
        ++turns;
    return turns > 0 ? m_knots.back() + (turns - 1) * period() : m_knots.front() + turns * period();
}

// The m with u_m <= t < u_(m+1); at the end of an open curve the last span. t lies in the domain.
template <int Dim>
int BSpline<Dim>::spanAt(double t) const
{
    const auto first = m_knots.begin() + (m_closed ? 0 : m_degree);
    const auto last = m_knots.begin() + pointCount();
    auto above = std::upper_bound(first, last, t);
    while (above - 1 != first && *(above - 1) == *above)
        --above;
    return static_cast<int>(above - m_knots.begin()) - 1;
}

// Of a knot of the domain, counted over one period.
template <int Dim>
int BSpline<Dim>::multiplicity(double knotValue) const
{
    const auto end = m_closed ? m_knots.begin() + pointCount() : m_knots.end();
    const auto count = [&](double value) {
        const auto [first, last] = std::equal_range(m_knots.begin(), end, value);
        return static_cast<int>(last - first);
    };
    return count(knotValue) + (m_closed && knotValue == domainStart() ? count(domainEnd()) : 0);
}

// The d + 1 points that act on a span.
template <int Dim>
std::array<typename BSpline<Dim>::Point, 4> BSpline<Dim>::localPoints(int span) const
{
    std::array<Point, 4> p = {Point::Zero(), Point::Zero(), Point::Zero(), Point::Zero()};
    for (int j = 0; j <= m_degree; ++j)
        p[static_cast<std::size_t>(j)] = m_points[static_cast<std::size_t>(pointIndex(span - m_degree + j))];
    return p;
}

// The polar form of the polynomial on a span, for d arguments: de Boor's scheme with one argument per step.
template <int Dim>
typename BSpline<Dim>::Point BSpline<Dim>::blossom(int span, const double* arguments) const
{
    return blossom(span, arguments, localPoints(span));
}

template <int Dim>
template <class Value>
Value BSpline<Dim>::blossom(int span, const double* arguments, std::array<Value, 4> p) const
{
    const int d = m_degree;
    std::array<double, 6> u{}; // u[i] is knot span - d + 1 + i
    for (int i = 0; i < 2 * d; ++i)
        u[static_cast<std::size_t>(i)] = knot(span - d + 1 + i);
    for (int r = 1; r <= d; ++r) {
        for (int j = d; j >= r; --j) {
            const auto k = static_cast<std::size_t>(j);
            const double low = u[k - 1];
            const double high = u[static_cast<std::size_t>(j + d - r)];
            const double alpha = (arguments[r - 1] - low) / (high - low);
            p[k] = (1 - alpha) * p[k - 1] + alpha * p[k];
        }
    }
    return p[static_cast<std::size_t>(d)];
}

template <int Dim>
typename BSpline<Dim>::Point BSpline<Dim>::at(double t) const
{
    const double inside = wrapped(t);
    const std::array<double, 3> arguments = {inside, inside, inside};
    return blossom(spanAt(inside), arguments.data());
}

template <int Dim>
std::vector<typename BSpline<Dim>::Influence> BSpline<Dim>::influencesAt(double t) const
{
    using Shares = Eigen::Vector4d;
    const double inside = wrapped(t);
    const int span = spanAt(inside);
    std::array<Shares, 4> units;
    for (int j = 0; j < 4; ++j)
        units[static_cast<std::size_t>(j)] = Shares::Unit(j);
    const std::array<double, 3> arguments = {inside, inside, inside};
    const Shares shares = blossom(span, arguments.data(), units);
    std::vector<Influence> influences;
    for (int j = 0; j <= m_degree; ++j)
        influences.push_back({pointIndex(span - m_degree + j), shares[j]});
    return influences;
}

template <int Dim>
typename BSpline<Dim>::Point BSpline<Dim>::derivative(double t, int order) const
{
    const int d = m_degree;
    if (order > d)
        return Point::Zero();
    const double inside = wrapped(t);
    const int m = spanAt(inside);
    std::array<Point, 4> p = localPoints(m);
    for (int k = 1; k <= order; ++k) {
        for (int j = 0; j <= d - k; ++j) {
            const auto i = static_cast<std::size_t>(j);
            p[i] = (d - k + 1) * (p[i + 1] - p[i]) / (knot(m + j + 1) - knot(m - d + j + k));
        }
    }
    const int rest = d - order; // the degree of the derivative; its points are p[0..rest]
    for (int r = 1; r <= rest; ++r) {
        for (int j = rest; j >= r; --j) {
            const double low = knot(m - rest + j);
            const double high = knot(m + 1 + j - r);
            const double alpha = (inside - low) / (high - low);
            const auto i = static_cast<std::size_t>(j);
            p[i] = (1 - alpha) * p[i - 1] + alpha * p[i];
        }
    }
    return p[static_cast<std::size_t>(rest)];
}

template <int Dim>
std::vector<double> BSpline<Dim>::breaks() const
{
    const auto first = m_knots.begin() + (m_closed ? 0 : m_degree);
    std::vector<double> values(first, m_knots.begin() + pointCount() + 1);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

template <int Dim>
std::vector<double> BSpline<Dim>::corners() const
{
    std::vector<double> values = breaks();
    values.pop_back();
    if (!m_closed)
        values.erase(values.begin());
    std::erase_if(values, [&](double t) { return multiplicity(t) < m_degree; });
    return values;
}

template <int Dim>
double BSpline<Dim>::parameterOfPoint(int i) const
{
    double sum = 0;
    for (int k = 1; k <= m_degree; ++k)
        sum += knot(i - shift() + k);
    return wrapped(sum / m_degree);
}

template <int Dim>
int BSpline<Dim>::pointAt(double t) const
{
    int best = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < pointCount(); ++i) {
        const double straight = std::abs(parameterOfPoint(i) - t);
        const double away = m_closed ? std::min(straight, period() - straight) : straight;
        if (away < nearest) {
            nearest = away;
            best = i;
        }
    }
    return best;
}

template <int Dim>
BSpline<Dim> BSpline<Dim>::withPoint(int i, const Point& p) const
{
    std::vector<Point> points = m_points;
    points.at(static_cast<std::size_t>(i)) = p;
    return withPoints(std::move(points));
}

template <int Dim>
BSpline<Dim> BSpline<Dim>::withPoints(std::vector<Point> points) const
{
    return BSpline(m_degree, m_closed, std::move(points), m_knots);
}

template class BSpline<2>;
template class BSpline<3>;

} // namespace bolster
