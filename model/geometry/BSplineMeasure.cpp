// Bounds, area and distances of a curve.
#include "BezierPieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

// Calls visit(u) for each u in (0, 1) where a u^2 + b u + c vanishes.
template <class Visit>
void eachRoot(double a, double b, double c, Visit visit)
{
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0)
        return;
    const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
    for (const double u : {q / a, c / q})
        if (u > 0 && u < 1) // not for infinity and NaN either
            visit(u);
}

constexpr double binomial[7][7] = {
    {1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}, {1, 5, 10, 10, 5, 1}, {1, 6, 15, 20, 15, 6, 1}};

// |C(u) - p|^2 on a part of a piece, as a Bernstein polynomial of twice the degree.
struct SquaredDistance {
    double start = 0;
    double end = 1;
    int degree = 2;
    std::array<double, 7> coefficients{};

    template <int Dim>
    SquaredDistance(const BezierPiece<Dim>& piece, const Eigen::Matrix<double, Dim, 1>& p)
        : degree(2 * piece.degree)
    {
        const auto d = static_cast<std::size_t>(piece.degree);
        std::array<Eigen::Matrix<double, Dim, 1>, 4> q;
        for (std::size_t i = 0; i <= d; ++i)
            q[i] = binomial[d][i] * (piece.points[i] - p);
        for (std::size_t i = 0; i <= d; ++i)
            for (std::size_t j = 0; j <= d; ++j)
                coefficients[i + j] += q[i].dot(q[j]);
        for (std::size_t k = 0; k <= 2 * d; ++k)
            coefficients[k] /= binomial[2 * d][k];
    }

    double smallest() const { return *std::min_element(coefficients.begin(), coefficients.begin() + degree + 1); }
    double largest() const { return *std::max_element(coefficients.begin(), coefficients.begin() + degree + 1); }

    // Whether there is at most one extremum inside: the derivative's coefficients change sign at most once.
    bool simple(double tolerance) const
    {
        int changes = 0;
        double before = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(degree); ++i) {
            const double difference = coefficients[i + 1] - coefficients[i];
            if (std::abs(difference) <= tolerance)
                continue;
            changes += before * difference < 0 ? 1 : 0;
            before = difference;
        }
        return changes <= 1;
    }

    void split(std::vector<SquaredDistance>& parts) const
    {
        SquaredDistance left = *this;
        SquaredDistance right = *this;
        left.end = right.start = (start + end) / 2;
        for (int r = degree; r > 0; --r) {
            for (std::size_t j = 0; j < static_cast<std::size_t>(r); ++j)
                right.coefficients[j] = (right.coefficients[j] + right.coefficients[j + 1]) / 2;
            left.coefficients[static_cast<std::size_t>(degree - r + 1)] = right.coefficients[0];
        }
        parts.push_back(right);
        parts.push_back(left);
    }
};

// Where the distance to p is smallest between two parameters of a piece, if it has one minimum there: the foot of
// the perpendicular by the Illinois method, on the curve itself for full accuracy.
template <int Dim>
double minimum(const BezierPiece<Dim>& piece, const Eigen::Matrix<double, Dim, 1>& p, double low, double high)
{
    const auto slope = [&](double u) { return (piece.at(u) - p).dot(piece.derivative(u)); };
    double atLow = slope(low);
    double atHigh = slope(high);
    if (atLow >= 0)
        return low;
    if (atHigh <= 0)
        return high;
    for (int i = 0; i < 100 && high - low > 1e-16; ++i) {
        const double u = std::clamp(high - atHigh * (high - low) / (atHigh - atLow), low, high);
        const double there = slope(u);
        if (there == 0 || u == low || u == high)
            return u;
        if (there < 0) {
            low = u;
            atLow = there;
            atHigh /= 2;
        } else {
            high = u;
            atHigh = there;
            atLow /= 2;
        }
    }
    return (low + high) / 2;
}

} // namespace

template <int Dim>
typename BSpline<Dim>::Box BSpline<Dim>::boundingBox() const
{
    Box box;
    for (const BezierPiece<Dim>& piece : bezierPieces(*this)) {
        box.extend(piece.front());
        box.extend(piece.back());
        // The derivative is (1-u)^2 v0 + 2 u (1-u) v1 + u^2 v2, of lower degree with fewer terms.
        const Point v0 = piece.points[1] - piece.points[0];
        const Point v1 = m_degree > 1 ? Point(piece.points[2] - piece.points[1]) : v0;
        const Point v2 = m_degree > 2 ? Point(piece.points[3] - piece.points[2]) : v1;
        for (int i = 0; i < Dim; ++i) {
            const auto extend = [&](double u) { box.extend(piece.at(u)); };
            if (m_degree == 3)
                eachRoot(v0[i] - 2 * v1[i] + v2[i], 2 * (v1[i] - v0[i]), v0[i], extend);
            else if (m_degree == 2)
                eachRoot(0, v1[i] - v0[i], v0[i], extend);
        }
    }
    return box;
}

template <int Dim>
double BSpline<Dim>::signedArea() const
{
    if (Dim != 2 || !m_closed)
        return 0;
    // Three Gauss points: exact for the polynomials of degree 5 that come up.
    static constexpr std::array<double, 3> node = {-0.77459666924148338, 0, 0.77459666924148338};
    static constexpr std::array<double, 3> weight = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    const Point origin = m_points.front();
    double twice = 0;
    for (const BezierPiece<Dim>& piece : bezierPieces(*this)) {
        for (std::size_t i = 0; i < node.size(); ++i) {
            const double u = (1 + node[i]) / 2;
            const Point p = piece.at(u) - origin;
            const Point v = piece.derivative(u);
            twice += weight[i] * (p[0] * v[1] - p[1] * v[0]);
        }
    }
    return twice / 2;
}

template <int Dim>
typename BSpline<Dim>::Closest BSpline<Dim>::closest(const Point& p) const
{
    const std::vector<BezierPiece<Dim>> pieces = bezierPieces(*this);
    Closest best;
    best.distance = std::numeric_limits<double>::infinity();
    const auto offer = [&](const BezierPiece<Dim>& piece, double u) {
        const Point q = piece.at(u);
        if (const double distance = (q - p).norm(); distance < best.distance)
            best = {wrapped(piece.parameter(u)), q, distance};
    };
    double size = 0;
    for (const BezierPiece<Dim>& piece : pieces) {
        offer(piece, 0);
        offer(piece, 1);
        for (int j = 1; j <= m_degree; ++j)
            size = std::max(size, (piece.points[static_cast<std::size_t>(j)] - pieces.front().front()).norm());
    }

    // Branch and bound: the squared distance lies above its smallest Bernstein coefficient.
    std::vector<SquaredDistance> stack;
    for (const BezierPiece<Dim>& piece : pieces) {
        stack.emplace_back(piece, p);
        while (!stack.empty()) {
            const SquaredDistance part = stack.back();
            stack.pop_back();
            const double largest = part.largest();
            const double useful = best.distance * (best.distance - 2e-10 * size) + 1e-14 * largest;
            if (part.smallest() >= useful)
                continue;
            if (!part.simple(1e-14 * largest) && part.end - part.start > 1e-9) {
                part.split(stack);
                continue;
            }
            offer(piece, part.start);
            offer(piece, part.end);
            offer(piece, minimum(piece, p, part.start, part.end));
        }
    }
    return best;
}

template BSpline<2>::Box BSpline<2>::boundingBox() const;
template BSpline<3>::Box BSpline<3>::boundingBox() const;
template double BSpline<2>::signedArea() const;
template double BSpline<3>::signedArea() const;
template BSpline<2>::Closest BSpline<2>::closest(const Vec2&) const;
template BSpline<3>::Closest BSpline<3>::closest(const Vec3&) const;

} // namespace bolster
