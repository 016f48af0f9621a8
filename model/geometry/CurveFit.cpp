#include "CurveFit.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <set>

namespace bolster {

namespace {

constexpr int degree = 3;
constexpr double exactWeight = 1e4; // of rows that must be met
constexpr int fewestPerSpan = 2;    // samples inside half a span, or it is not halved

class Fitter {
public:
    explicit Fitter(const CurveSamples& samples)
        : m_samples(samples)
        , m_corners(samples.corners.begin(), samples.corners.end())
        , m_breaks(m_corners)
    {
        m_breaks.insert(samples.start);
        m_breaks.insert(samples.end);
        // A closed curve without corners has at least three knots.
        for (int k = 1; samples.closed && m_corners.empty() && k < 4; ++k)
            m_breaks.insert(samples.start + (samples.end - samples.start) * k / 4);
    }

    BSpline3 fit(double tolerance)
    {
        for (;;) {
            const BSpline3 curve = leastSquares();
            if (!refine(curve, tolerance))
                return curve;
        }
    }

private:
    bool isCorner(double t) const { return m_corners.contains(t); }

    std::vector<double> knots() const
    {
        std::vector<double> knots;
        const bool closed = m_samples.closed;
        const int atStart = closed ? (isCorner(m_samples.start) ? degree - 1 : 1) : degree + 1;
        const int atEnd = closed && atStart == 1 ? 1 : closed ? degree - 1 : degree + 1;
        for (double t : m_breaks) {
            const int count = t == m_samples.start ? atStart
                              : t == m_samples.end ? atEnd
                              : isCorner(t)        ? degree
                                                   : 1;
            knots.insert(knots.end(), static_cast<std::size_t>(count), t);
        }
        return knots;
    }

    BSpline3 leastSquares() const
    {
        const std::vector<double> knotsNow = knots();
        const bool closed = m_samples.closed;
        const auto count = static_cast<Eigen::Index>(knotsNow.size()) - (closed ? 1 : degree + 1);
        const auto rows = static_cast<Eigen::Index>(m_samples.points.size());
        Eigen::MatrixXd basis(rows, count);
        Eigen::MatrixX3d places(rows, 3);
        for (Eigen::Index i = 0; i < rows; ++i)
            places.row(i) = m_samples.points[static_cast<std::size_t>(i)].transpose();
        // The basis functions as curves: all points 0 but one.
        for (Eigen::Index j = 0; j < count; ++j) {
            std::vector<Vec2> unit(static_cast<std::size_t>(count), Vec2::Zero());
            unit[static_cast<std::size_t>(j)].x() = 1;
            const BSpline2 function(degree, closed, std::move(unit), knotsNow);
            for (Eigen::Index i = 0; i < rows; ++i)
                basis(i, j) = function.at(m_samples.parameters[static_cast<std::size_t>(i)]).x();
        }
        for (Eigen::Index i = 0; i < rows; ++i)
            if (isExact(i)) {
                basis.row(i) *= exactWeight;
                places.row(i) *= exactWeight;
            }
        const Eigen::MatrixX3d solution = basis.colPivHouseholderQr().solve(places);
        std::vector<Vec3> points;
        for (Eigen::Index j = 0; j < count; ++j)
            points.emplace_back(solution.row(j).transpose());
        return {degree, closed, std::move(points), knotsNow};
    }

    bool isExact(Eigen::Index sample) const
    {
        const bool end = sample == 0 || sample + 1 == static_cast<Eigen::Index>(m_samples.points.size());
        return (end && !m_samples.closed) || isCorner(m_samples.parameters[static_cast<std::size_t>(sample)]);
    }

    /// Halves the spans in which the curve is too far away. False when none is, or none can be halved.
    bool refine(const BSpline3& curve, double tolerance)
    {
        const std::vector<double> breaks(m_breaks.begin(), m_breaks.end());
        std::vector<double> errors(breaks.size() - 1, 0);
        double worst = 0;
        for (std::size_t i = 0; i < m_samples.points.size(); ++i) {
            const double t = m_samples.parameters[i], error = (curve.at(t) - m_samples.points[i]).norm();
            const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, t);
            double& span = errors[static_cast<std::size_t>(after - breaks.begin()) - 1];
            span = std::max(span, error);
            worst = std::max(worst, error);
        }
        if (worst <= tolerance)
            return false;
        bool refined = false;
        for (std::size_t k = 0; k < errors.size(); ++k) {
            const double middle = 0.5 * (breaks[k] + breaks[k + 1]);
            const bool wanted = errors[k] > std::max(tolerance, 0.5 * worst);
            if (wanted && samplesBetween(breaks[k], middle) >= fewestPerSpan &&
                samplesBetween(middle, breaks[k + 1]) >= fewestPerSpan)
                refined |= m_breaks.insert(middle).second;
        }
        return refined;
    }

    std::ptrdiff_t samplesBetween(double t0, double t1) const
    {
        const auto& t = m_samples.parameters;
        return std::lower_bound(t.begin(), t.end(), t1) - std::upper_bound(t.begin(), t.end(), t0);
    }

    const CurveSamples& m_samples;
    std::set<double> m_corners;
    std::set<double> m_breaks;
};

} // namespace

BSpline3 fitCurve(const CurveSamples& samples, double tolerance)
{
    return Fitter(samples).fit(tolerance);
}

} // namespace bolster
