// Arc length of a curve as a function of its parameter, and back.
#pragma once

#include "BSpline.h"

namespace bolster {

/// A table over the curve's polynomial pieces with Gauss-Legendre quadrature in between; relative accuracy
/// about 1e-9. On a closed curve parameters and lengths continue beyond the domain periodically.
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
    BSpline<Dim> m_curve;
    std::vector<double> m_parameters; // increasing; subdivided until the quadrature is accurate
    std::vector<double> m_lengths;    // from the start, same size
};

using ArcLength2 = ArcLength<2>;
using ArcLength3 = ArcLength<3>;

extern template class ArcLength<2>;
extern template class ArcLength<3>;

} // namespace bolster
