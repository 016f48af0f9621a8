// Adding curves to patches: handle curves and fancy seams (paper, section 3.5).
#pragma once

#include "Design.h"
#include "SurfaceMesh.h"

namespace bolster::edits {

/// Where a curve in a patch (outline coordinates, mm) lies on a surface, as a cubic within 0.2 mm: equal parameters
/// belong together. Corners of the curve stay corners where the surface's line has a kink. Nothing when the surface
/// has no such patch.
std::optional<BSpline3> liftedCurve(const SurfaceMesh& surface, ElementId patch, const BSpline2& curve);

/// Adds a handle curve whose target lies where the curve is on the surface, so that the surface stays as it is. It
/// stores what was found: opening the design needs no surface. Empty when the surface lacks the patch.
Edit addHandleCurve(const Design& design, const SurfaceMesh& surface, ElementId patch, BSpline2 curve,
                    const std::string& name);
/// Adds a fancy seam with the usual measures.
Edit addFancySeam(const Design& design, ElementId patch, BSpline2 curve, const std::string& name);

/// The curve through control points that a user draws: a polygon with arc length as parameter, or as smooth as so
/// few points allow. Nothing when that is no curve.
std::optional<BSpline2> drawnCurve(const std::vector<Vec2>& points, bool closed, bool smooth);

} // namespace bolster::edits
