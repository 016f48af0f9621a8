// Changing a curve's points and knots: insertion, removal, parts, reversal.
#include "BSpline.h"

#include "SplineKnots.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bolster {

namespace {

/// Least squares for a few points of a curve, the free ones, from equations a P_i + b P_j = target.
template <int Dim>
class PointFit {
public:
    using Point = Eigen::Matrix<double, Dim, 1>;

    explicit PointFit(int pointCount)
        : m_column(static_cast<std::size_t>(pointCount), -1)
    {}

    void free(int point)
    {
        int& column = m_column[static_cast<std::size_t>(point)];
        if (column < 0)
            column = m_columns++;
    }

    /// Points that are not free count with their present places. Indices with weight 0 may be out of range.
    void require(const std::vector<Point>& points, int i, double a, int j, double b, Point target)
    {
        Eigen::Vector4d row = Eigen::Vector4d::Zero();
        for (const auto& [point, weight] : {std::pair(i, a), std::pair(j, b)}) {
            if (weight == 0)
                continue;
            if (const int column = m_column[static_cast<std::size_t>(point)]; column >= 0)
                row[column] += weight;
            else
                target -= weight * points[static_cast<std::size_t>(point)];
        }
        m_rows.push_back(row);
        m_targets.push_back(target);
    }

    /// Places the free points; returns the sum of the squared residuals.
    double solve(std::vector<Point>& points) const
    {
        Eigen::MatrixXd matrix(m_rows.size(), m_columns);
        Eigen::MatrixXd targets(m_rows.size(), Dim);
        for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
            matrix.row(i) = m_rows[static_cast<std::size_t>(i)].head(m_columns).transpose();
            targets.row(i) = m_targets[static_cast<std::size_t>(i)].transpose();
        }
        if (m_columns == 0)
            return targets.squaredNorm();
        const Eigen::MatrixXd found = matrix.colPivHouseholderQr().solve(targets);
        for (std::size_t i = 0; i < points.size(); ++i)
            if (m_column[i] >= 0)
                points[i] = found.row(m_column[i]).transpose();
        return (matrix * found - targets).squaredNorm();
    }

private:
    std::vector<int> m_column; // of each point, -1: not free
    int m_columns = 0;         // at most degree + 1
    std::vector<Eigen::Vector4d> m_rows;
    std::vector<Point> m_targets;
};

} // namespace

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

// The same closed curve with its start at another knot.
template <int Dim>
BSpline<Dim> BSpline<Dim>::startingAtKnot(int index) const
{
    BSpline turned = *this;
    const int n = pointCount();
    for (int i = 0; i < n; ++i) {
        turned.m_knots[static_cast<std::size_t>(i)] = knot(i + index);
        turned.m_points[static_cast<std::size_t>(i)] =
            m_points[static_cast<std::size_t>(((i + index) % n + n) % n)];
    }
    turned.m_knots[static_cast<std::size_t>(n)] = knot(n + index);
    return turned;
}

// One copy of a knot less. Inserting it again would mix a few points of the result, Q_(m-d) to Q_(m-s), into those
// of this curve: they are found by least squares, the others stay. So do corners and the ends of an open curve,
// except the point `removed`. `change` becomes the sum of the squared residuals.
template <int Dim>
BSpline<Dim> BSpline<Dim>::withoutKnot(double place, int removed, double& change) const
{
    const int d = m_degree;
    const int n = pointCount();
    if (m_closed && place == domainStart() && knot(1) != place) {
        // A knot is removed behind one of the same value or behind another one: turn until there is one in front.
        const bool single = multiplicity(place) == 1;
        const int turn = single ? 1 : -1;
        return startingAtKnot(turn).withoutKnot(single ? domainEnd() : place, removed - turn, change);
    }
    BSpline reduced = *this;
    reduced.m_knots.erase(std::upper_bound(m_knots.begin(), m_knots.begin() + n, place) - 1 - m_knots.begin() +
                          reduced.m_knots.begin());
    reduced.m_points.pop_back();
    const int m = reduced.spanAt(place);
    const int s = multiplicity(place) - 1;
    const int first = m - d;
    const int last = m - s;
    for (int j = m_closed ? m - n + 1 : 0; j < (m_closed ? m + 1 : n); ++j)
        if (j <= first || j > last)
            reduced.m_points[static_cast<std::size_t>(reduced.pointIndex(j > last ? j - 1 : j))] =
                m_points[static_cast<std::size_t>(pointIndex(j))];

    const auto stays = [&](int basis) {
        return knot(basis + 1) == knot(basis + d) && pointIndex(basis) != (removed % n + n) % n;
    };
    PointFit<Dim> fit(reduced.pointCount());
    for (int q = first; q <= last; ++q)
        if (!(q == first && stays(first)) && !(q == last && stays(last + 1)))
            fit.free(reduced.pointIndex(q));
    for (int j = first; j <= last + 1; ++j) { // P_j = alpha Q_j + (1 - alpha) Q_(j-1)
        const double low = reduced.knot(j);
        const double alpha = j == first ? 1 : j > last ? 0 : (place - low) / (reduced.knot(j + d) - low);
        fit.require(reduced.m_points, reduced.pointIndex(j), alpha, reduced.pointIndex(j - 1), 1 - alpha,
                    m_points[static_cast<std::size_t>(pointIndex(j))]);
    }
    change = fit.solve(reduced.m_points);
    return reduced;
}

template <int Dim>
std::optional<BSpline<Dim>> BSpline<Dim>::withoutPoint(int i) const
{
    if (pointCount() <= (m_closed ? 3 : m_degree + 1))
        return std::nullopt;
    std::optional<BSpline> best;
    double least = std::numeric_limits<double>::infinity();
    const int basis = i - shift();
    const bool isCorner = knot(basis + 1) == knot(basis + m_degree);
    for (int k = 1; k <= m_degree; ++k) {
        const double place = wrapped(knot(basis + k));
        const bool end = !m_closed && (place == domainStart() || place == domainEnd());
        if (end || (multiplicity(place) >= m_degree && !isCorner))
            continue;
        double change = 0;
        BSpline reduced = withoutKnot(place, i, change);
        if (change < least && !problem(m_degree, m_closed, reduced.m_points, reduced.m_knots)) {
            least = change;
            best = std::move(reduced);
        }
    }
    return best;
}

template BSpline<2> BSpline<2>::withKnot(double) const;
template BSpline<3> BSpline<3>::withKnot(double) const;
template BSpline<2> BSpline<2>::part(double, double) const;
template BSpline<3> BSpline<3>::part(double, double) const;
template BSpline<2> BSpline<2>::reversed() const;
template BSpline<3> BSpline<3>::reversed() const;
template std::optional<BSpline<2>> BSpline<2>::withoutPoint(int) const;
template std::optional<BSpline<3>> BSpline<3>::withoutPoint(int) const;
template BSpline<2> BSpline<2>::startingAtKnot(int) const;
template BSpline<3> BSpline<3>::startingAtKnot(int) const;
template BSpline<2> BSpline<2>::withoutKnot(double, int, double&) const;
template BSpline<3> BSpline<3>::withoutKnot(double, int, double&) const;
template double BSpline<2>::nearestKnot(double) const;
template double BSpline<3>::nearestKnot(double) const;

} // namespace bolster
