// What belongs to a scan and what is cut away of it.
#pragma once

#include "Design.h"

namespace bolster::edits {

/// Of design coordinates, mm: points with normal . p <= distance.
HalfSpace halfSpaceIn(const Placement& placement, const Vec3& normal, double distance);
/// What lies inside a box along the design's axes (mm), or with `keep` what lies outside.
ScanCut boxCut(const Placement& placement, const Box3& box, bool keep);

Edit addCut(const Design& design, ElementId scan, ScanCut cut);
/// Nothing is cut away any more.
Edit removeCuts(const Design& design, ElementId scan);
/// Cuts away what lies below this height (mm), instead of below the last one.
Edit cutFloor(const Design& design, ElementId scan, double height);
/// The height of the floor that is cut away, mm.
std::optional<double> floorOf(const Scan& scan);

} // namespace bolster::edits
