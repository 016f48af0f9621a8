// A curve through given points that follows a surface between them.
#pragma once

#include "BSpline.h"

#include <functional>

namespace bolster {

/// The nearest place on what the curve follows; nothing where there is none.
using CoverFollow = std::function<std::optional<Vec3>(const Vec3&)>;

struct CoverPath {
    std::vector<Vec3> points; ///< of a smooth one close together, mm; of a closed one the first is not repeated
    bool closed = false;
    bool smooth = true;
};

/// Smooth and on what it follows, or straight from point to point, whatever lies between them. Points closer than
/// 0.001 mm to the one before are left out; fewer than two, or three of a closed one, give an empty path.
CoverPath pathAlong(const std::vector<Vec3>& points, bool closed, bool smooth, const CoverFollow& follow);

/// Of a smooth path the cubic with few control points within 0.5 mm of it; of a straight one the polygon through
/// the given points. Nothing when the path is empty.
std::optional<BSpline3> curveAlong(const CoverPath& path);

} // namespace bolster
