// A B-spline as one Bezier curve per span: the form in which bounds, roots and quadrature are easy.
#pragma once

#include "BSpline.h"

#include <array>
#include <vector>

namespace bolster {

/// C(start + u (end - start)) = sum B_i(u) points[i], u in [0, 1], for points 0 to degree.
template <int Dim>
struct BezierPiece {
    using Point = Eigen::Matrix<double, Dim, 1>;

    int degree = 1;
    double start = 0;
    double end = 1;
    std::array<Point, 4> points = {Point::Zero(), Point::Zero(), Point::Zero(), Point::Zero()};

    const Point& front() const { return points[0]; }
    const Point& back() const { return points[static_cast<std::size_t>(degree)]; }
    double parameter(double u) const { return start + u * (end - start); }

    Point at(double u) const
    {
        std::array<Point, 4> p = points;
        for (int r = degree; r > 0; --r)
            for (int j = 0; j < r; ++j)
                interpolate(p, j, u);
        return p[0];
    }

    /// With respect to u, not to the curve's parameter.
    Point derivative(double u) const
    {
        std::array<Point, 4> p = points;
        for (std::size_t j = 0; j < static_cast<std::size_t>(degree); ++j)
            p[j] = degree * (p[j + 1] - p[j]);
        for (int r = degree - 1; r > 0; --r)
            for (int j = 0; j < r; ++j)
                interpolate(p, j, u);
        return p[0];
    }

    /// The two halves (de Casteljau).
    std::array<BezierPiece, 2> halves() const
    {
        std::array<BezierPiece, 2> parts = {*this, *this};
        const double middle = parameter(0.5);
        parts[0].end = middle;
        parts[1].start = middle;
        std::array<Point, 4>& p = parts[1].points;
        for (int r = degree; r > 0; --r) {
            for (int j = 0; j < r; ++j)
                interpolate(p, j, 0.5);
            parts[0].points[static_cast<std::size_t>(degree - r + 1)] = p[0];
        }
        return parts;
    }

private:
    static void interpolate(std::array<Point, 4>& p, int j, double u)
    {
        const auto i = static_cast<std::size_t>(j);
        p[i] = (1 - u) * p[i] + u * p[i + 1];
    }
};

/// In increasing parameter; every span once.
template <int Dim>
std::vector<BezierPiece<Dim>> bezierPieces(const BSpline<Dim>& curve);

extern template std::vector<BezierPiece<2>> bezierPieces(const BSpline<2>& curve);
extern template std::vector<BezierPiece<3>> bezierPieces(const BSpline<3>& curve);

} // namespace bolster
