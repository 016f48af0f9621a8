// Where a line of straight segments crosses an outline. Private to the library.
#pragma once

#include "BSpline.h"

#include <vector>

namespace bolster::edits {

struct OutlineCrossing {
    double along = 0;     ///< the segment's number plus the share of it
    double parameter = 0; ///< of the outline; a corner that is almost met exactly
    Vec2 point = Vec2::Zero();
};

/// In the order of the line. Ends of the line within 0.05 mm of the outline count.
std::vector<OutlineCrossing> outlineCrossings(const BSpline2& outline, const std::vector<Vec2>& line);

/// The line from one of its crossings to another one.
std::vector<Vec2> between(const std::vector<Vec2>& line, const OutlineCrossing& from, const OutlineCrossing& to);

/// Whether a point lies inside an outline; on its border either.
bool isInside(const BSpline2& outline, const Vec2& point);

} // namespace bolster::edits
