// Changing a curve's points and knots: insertion, removal, parts, reversal.
#include "BSpline.h"

#include "SplineKnots.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bolster {

// Boehm's algorithm. With u_m <= t < u_(m+1) and t of multiplicity s already, only the bases m-d+1 to m-s mix two
// points; those above move up by one.
template <int Dim>
BSpline<Dim> BSpline<Dim>::withKnot(double t) const
{
    const int d = m_degree;
    const int n = pointCount();
    const double place = nearestKnot(wrapped(t));
    const int s = multiplicity(place);
    if (s >= d)
        return *this;
    const int m = spanAt(place);

    const int first = m_closed ? m - n : 0; // the bases of the new curve, a whole turn when closed
    const int last = m_closed ? m : n;
    std::vector<Point> points(static_cast<std::size_t>(n) + 1);
    for (int j = first; j <= last; ++j) {
        const int target = m_closed ? ((j + shift()) % (n + 1) + n + 1) % (n + 1) : j;
        const auto old = [&](int basis) { return m_points[static_cast<std::size_t>(pointIndex(basis))]; };
        Point& point = points[static_cast<std::size_t>(target)];
        if (j <= m - d) {
            point = old(j);
        } else if (j > m - s) {
            point = old(j - 1);
        } else {
            const double alpha = (place - knot(j)) / (knot(j + d) - knot(j));
            point = (1 - alpha) * old(j - 1) + alpha * old(j);
        }
    }
    std::vector<double> knots = m_knots;
    knots.insert(knots.begin() + m + 1, place);
    return BSpline(d, m_closed, std::move(points), std::move(knots));
}

// The place itself, or the knot that is too close to it to be another one.
template <int Dim>
double BSpline<Dim>::nearestKnot(double t) const
{
    const double gap = 2 * spline::smallestGap(m_knots);
    if (domainEnd() - t < gap)
        return m_closed ? domainStart() : domainEnd();
    for (const double k : breaks())
        if (std::abs(k - t) < gap)
            return k;
    return t;
}

template <int Dim>
BSpline<Dim> BSpline<Dim>::part(double t0, double t1) const
{
    const double period = this->period();
    const double gap = 2 * spline::smallestGap(m_knots);
    double length = m_closed && t1 <= t0 ? t1 - t0 + period : t1 - t0;
    if (m_closed && length > period)
        length = std::remainder(length, period) + (std::remainder(length, period) > 0 ? 0 : period);
    if (!(length >= gap))
        throw std::invalid_argument("a part of a curve must not be empty");

    BSpline cut = *this;
    for (int i = 0; i < m_degree; ++i)
        cut = cut.withKnot(t0).withKnot(t1);
    const int d = m_degree;
    const int n = cut.pointCount();
    const double from = cut.nearestKnot(wrapped(t0));
    const double to = cut.nearestKnot(wrapped(t1));
    const int m0 = cut.spanAt(from);
    int m1 = 0; // the first knot of those at the end
    if (m_closed) {
        const auto lower = std::lower_bound(cut.m_knots.begin(), cut.m_knots.begin() + n, to);
        m1 = static_cast<int>(lower - cut.m_knots.begin());
        if (to <= from)
            m1 += n;
        while (cut.knot(m1 - 1) == cut.knot(m1)) // knots at the start lie on both sides of it
            --m1;
    } else {
        const auto lower = std::lower_bound(cut.m_knots.begin(), cut.m_knots.end(), to);
        m1 = static_cast<int>(lower - cut.m_knots.begin());
    }

    std::vector<Point> points;
    std::vector<double> knots(static_cast<std::size_t>(d) + 1, from);
    for (int j = m0 - d; j < m1; ++j)
        points.push_back(cut.m_points[static_cast<std::size_t>(cut.pointIndex(j))]);
    for (int i = m0 + 1; i < m1; ++i)
        knots.push_back(cut.knot(i));
    knots.insert(knots.end(), static_cast<std::size_t>(d) + 1, cut.knot(m1));
    return BSpline(d, false, std::move(points), std::move(knots));
}

template <int Dim>
BSpline<Dim> BSpline<Dim>::reversed() const
{
    const int n = pointCount();
    std::vector<Point> points(m_points.rbegin(), m_points.rend());
    if (m_closed) {
        // The support of a basis is mirrored, which takes point i to n - i (even number of spans) or n - i - 1.
        const int mirror = (n + 2 * shift() - m_degree - 1) % n;
        for (int i = 0; i < n; ++i)
            points[static_cast<std::size_t>(((mirror - i) % n + n) % n)] = m_points[static_cast<std::size_t>(i)];
        if (const auto corners = cornerIndices(); corners && domainStart() == 0) {
            std::vector<int> mirrored;
            for (const int corner : *corners)
                mirrored.push_back((n - corner) % n);
            std::sort(mirrored.begin(), mirrored.end());
            return withCorners(std::move(points), mirrored); // the same knots without rounding
        }
    }
    std::vector<double> knots(m_knots.rbegin(), m_knots.rend());
    for (double& k : knots)
        k = k == m_knots.front()  ? m_knots.back()
            : k == m_knots.back() ? m_knots.front()
                                  : m_knots.front() + (m_knots.back() - k);
    return BSpline(m_degree, m_closed, std::move(points), std::move(knots));
}

template <int Dim>
std::optional<BSpline<Dim>> BSpline<Dim>::withoutPoint(int) const
{
    return std::nullopt;
}

template BSpline<2> BSpline<2>::withKnot(double) const;
template BSpline<3> BSpline<3>::withKnot(double) const;
template BSpline<2> BSpline<2>::part(double, double) const;
template BSpline<3> BSpline<3>::part(double, double) const;
template BSpline<2> BSpline<2>::reversed() const;
template BSpline<3> BSpline<3>::reversed() const;
template std::optional<BSpline<2>> BSpline<2>::withoutPoint(int) const;
template std::optional<BSpline<3>> BSpline<3>::withoutPoint(int) const;
template double BSpline<2>::nearestKnot(double) const;
template double BSpline<3>::nearestKnot(double) const;

} // namespace bolster
