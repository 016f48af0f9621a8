// Arc length of a curve as a function of its parameter, and back.
#pragma once

#include "BezierPieces.h"

#include <span>

namespace bolster {

/// A table over the curve's polynomial pieces with Gauss-Legendre quadrature in between; accurate to about 1e-9 of
/// the total. On a closed curve parameters and lengths continue beyond the domain periodically.
template <int Dim>
class ArcLength {
public:
    explicit ArcLength(const BSpline<Dim>& curve);

    double total() const { return m_lengths.back(); }
    /// Length from the domain's start to t (negative before it, more than total() after it, when closed).
    double at(double t) const;
    double between(double t0, double t1) const { return at(t1) - at(t0); }
    /// The parameter at which the length from the domain's start is s.
    double parameterAt(double s) const;

private:
    bool m_closed;
    std::vector<BezierPiece<Dim>> m_pieces; // so short that the quadrature is accurate
    std::vector<double> m_lengths;          // up to the start of each piece, and the total
};

using ArcLength2 = ArcLength<2>;
using ArcLength3 = ArcLength<3>;

extern template class ArcLength<2>;
extern template class ArcLength<3>;

/// The place of a row of points that has this share of the row's length before it; 0 to 1. The row has a point at
/// least.
Vec3 placeAlong(std::span<const Vec3> row, double share);

} // namespace bolster
