// Takes out knots that cutting a curve, or joining two, has left behind. Private to the library.
#pragma once

#include "BSpline.h"

namespace bolster::edits {

/// Without those knots at the parameter that the shape does not need, to within 1e-7 of the curve's size.
template <int Dim>
BSpline<Dim> withoutNeedlessKnots(BSpline<Dim> curve, double t)
{
    const double tolerance = 1e-7 * curve.boundingBox().diagonal().norm();
    for (int i = 0; i < curve.degree(); ++i) {
        const auto fewer = curve.withoutPoint(curve.pointAt(curve.wrapped(t)));
        if (!fewer)
            break;
        const int samples = 8 * curve.pointCount();
        for (int k = 0; k < samples; ++k) {
            const double at = curve.domainStart() + curve.period() * k / samples;
            if ((curve.at(at) - fewer->at(at)).norm() > tolerance)
                return curve;
        }
        if ((curve.at(t) - fewer->at(t)).norm() > tolerance)
            break;
        curve = *fewer;
    }
    return curve;
}

} // namespace bolster::edits
