// A curve through given points that follows a surface between them.
#pragma once

#include "BSpline.h"

#include <functional>

namespace bolster {

/// The nearest place on what the curve follows; nothing where there is none.
using SurfaceFollow = std::function<std::optional<Vec3>(const Vec3&)>;

struct SurfacePath {
    std::vector<Vec3> points;       ///< close together, mm; of a closed one the first is not repeated
    std::vector<std::size_t> given; ///< which of them are the given points
    bool closed = false;
};

/// Smooth, or as straight as the surface allows. Points closer than 0.001 mm to the one before are left out; fewer
/// than two, or three of a closed one, give an empty path.
SurfacePath pathAlong(const std::vector<Vec3>& points, bool closed, bool smooth, const SurfaceFollow& follow);

/// The cubic with few control points within 0.5 mm of the path; with `corners` it may have a corner at each given
/// point. Nothing when the path is empty.
std::optional<BSpline3> curveAlong(const SurfacePath& path, bool corners);

} // namespace bolster
