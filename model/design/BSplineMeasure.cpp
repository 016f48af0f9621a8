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
    Closest best;
    best.distance = std::numeric_limits<double>::infinity();
    for (const BezierPiece<Dim>& piece : bezierPieces(*this)) {
        for (int k = 0; k <= 64; ++k) {
            const Point q = piece.at(k / 64.0);
            if ((q - p).norm() < best.distance)
                best = {wrapped(piece.parameter(k / 64.0)), q, (q - p).norm()};
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
