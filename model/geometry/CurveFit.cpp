#include "CurveFit.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <set>

namespace bolster {

namespace {

constexpr int degree = 3;
constexpr double straight = 1e-5; // weight of a straight control polygon: it decides where samples do not
constexpr int fewestPerSpan = 2;  // samples inside half a span, or it is not halved

/// Sums of squares: the normal equations of control points, some of which are where they have to be.
class Normals {
public:
    explicit Normals(int count)
        : m_right(Eigen::MatrixX3d::Zero(count, 3))
    {}

    void add(const std::vector<BSpline3::Influence>& influences, const Vec3& place)
    {
        for (const auto& [a, shareOfA] : influences) {
            m_right.row(a) += shareOfA * place.transpose();
            for (const auto& [b, shareOfB] : influences)
                m_entries.emplace_back(a, b, shareOfA * shareOfB);
        }
    }

    void solve(const std::vector<bool>& met, std::vector<Vec3>& points)
    {
        const auto isMet = [&](Eigen::Index k) { return met[static_cast<std::size_t>(k)]; };
        for (const Eigen::Triplet<double>& entry : m_entries)
            if (!isMet(entry.row()) && isMet(entry.col()))
                m_right.row(entry.row()) -=
                    entry.value() * points[static_cast<std::size_t>(entry.col())].transpose();
        std::erase_if(m_entries, [&](const auto& entry) { return isMet(entry.row()) || isMet(entry.col()); });
        for (int k = 0; k < m_right.rows(); ++k)
            if (isMet(k)) {
                m_entries.emplace_back(k, k, 1);
                m_right.row(k) = points[static_cast<std::size_t>(k)].transpose();
            }
        Eigen::SparseMatrix<double> matrix(m_right.rows(), m_right.rows());
        matrix.setFromTriplets(m_entries.begin(), m_entries.end());
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
        const Eigen::MatrixX3d solution = factors.solve(m_right);
        for (Eigen::Index k = 0; k < solution.rows(); ++k)
            if (!isMet(k))
                points[static_cast<std::size_t>(k)] = solution.row(k).transpose();
    }

private:
    std::vector<Eigen::Triplet<double>> m_entries;
    Eigen::MatrixX3d m_right;
};

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
        const auto count = static_cast<int>(knotsNow.size()) - (m_samples.closed ? 1 : degree + 1);
        BSpline3 curve(degree, m_samples.closed, std::vector<Vec3>(static_cast<std::size_t>(count), Vec3::Zero()),
                       knotsNow);
        std::vector<Vec3> points = curve.points();
        std::vector<bool> met(points.size(), false); // a control point is where the curve passes it
        Normals normals(count);
        for (std::size_t i = 0; i < m_samples.points.size(); ++i) {
            const std::vector<BSpline3::Influence> influences = curve.influencesAt(m_samples.parameters[i]);
            if (isExact(i)) {
                const int here = std::ranges::max_element(influences, {}, &BSpline3::Influence::share)->point;
                met[static_cast<std::size_t>(here)] = true;
                points[static_cast<std::size_t>(here)] = m_samples.points[i];
            } else {
                normals.add(influences, m_samples.points[i]);
            }
        }
        for (int k = 0; k < count; ++k)
            if (m_samples.closed || (k > 0 && k + 1 < count))
                normals.add({{(k + count - 1) % count, -straight}, {k, 2 * straight}, {(k + 1) % count, -straight}},
                            Vec3::Zero());
        normals.solve(met, points);
        return curve.withPoints(std::move(points));
    }

    bool isExact(std::size_t sample) const
    {
        const bool end = sample == 0 || sample + 1 == m_samples.points.size();
        return (end && !m_samples.closed) || isCorner(m_samples.parameters[sample]);
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
