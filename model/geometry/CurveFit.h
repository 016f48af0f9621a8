// A B-spline near a dense row of points.
#pragma once

#include "BSpline.h"

namespace bolster {

/// Points of a curve in space, close together, with the parameters that the spline shall have there.
struct CurveSamples {
    std::vector<Vec3> points;       ///< mm; of a closed curve the first one is not repeated
    std::vector<double> parameters; ///< increasing, from `start`; up to `end` if open
    double start = 0;
    double end = 1; ///< of a closed curve: a period after `start`
    bool closed = false;
    std::vector<double>
        corners; ///< parameters of samples at which the tangent may jump, `start` included if closed
};

/// The cubic with few control points that is nowhere farther than `tolerance` (mm) from its samples, by least
/// squares; knots are inserted where it is farthest until it is near enough. Ends and corners are met exactly;
/// corners have triple knots. `problem` of such a curve has nothing to say for finite points in at least two
/// places.
BSpline3 fitCurve(const CurveSamples& samples, double tolerance);

} // namespace bolster
