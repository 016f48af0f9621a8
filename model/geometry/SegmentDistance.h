// How far a place is from a straight piece of a line.
#pragma once

#include "Geometry.h"

#include <algorithm>

namespace bolster {

/// The nearest place between the ends, which may be one and the same.
template <int Dimensions>
Eigen::Matrix<double, Dimensions, 1> nearestOnSegment(const Eigen::Matrix<double, Dimensions, 1>& place,
                                                      const Eigen::Matrix<double, Dimensions, 1>& from,
                                                      const Eigen::Matrix<double, Dimensions, 1>& to)
{
    const Eigen::Matrix<double, Dimensions, 1> way = to - from;
    const double square = way.squaredNorm();
    const double share = square > 0 ? std::clamp((place - from).dot(way) / square, 0.0, 1.0) : 0;
    return from + share * way;
}

template <int Dimensions>
double segmentDistance(const Eigen::Matrix<double, Dimensions, 1>& place,
                       const Eigen::Matrix<double, Dimensions, 1>& from,
                       const Eigen::Matrix<double, Dimensions, 1>& to)
{
    return (nearestOnSegment<Dimensions>(place, from, to) - place).norm();
}

} // namespace bolster
