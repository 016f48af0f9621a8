// Which elements of a design are mirror twins, and what their curves look like in the mirror.
#pragma once

#include "Design.h"

#include <map>

namespace bolster {

/// A handle curve has points in the pattern and in space: `released` numbers the latter from here.
inline constexpr int firstTwinSpacePoint = mostCurvePoints;
/// How far (mm) a point may be from its mirror image and still be one.
inline constexpr double mirrorTolerance = 1e-6;

/// What a follower says of its twin; null for others and for kinds that have none.
const Twin* twinLink(const Element& element);
/// The same element with another link; it must be of a kind with one.
ElementPtr withTwinLink(const Element& element, std::optional<Twin> link);
/// Patches, fixation curves, handle curves and fancy seams have twins.
bool canBeTwin(const Element& element);

/// Originals by follower: the links that hold. One does not when the other element is missing, of another kind, a
/// follower itself, or has a follower with a smaller id.
std::map<ElementId, ElementId> twinPairs(const Design& design);
/// The twin of either kind, or noElement.
ElementId twinOf(const Design& design, ElementId id);
/// The released points of the pair that the element belongs to.
std::vector<int> releasedPoints(const Design& design, ElementId id);

/// The plane and axis of the design, or the default.
Symmetry symmetryOf(const Design& design);

/// Same kind of curve, parameter by parameter; an empty one gives an empty one. Nothing beyond 1e7 mm.
std::optional<BSpline2> mirroredCurve(const BSpline2& curve);
std::optional<BSpline3> mirroredCurve(const BSpline3& curve, const Symmetry& symmetry);
/// Grain (degrees) in the mirror.
double mirroredGrain(double grain);
Orientation mirroredOrientation(Orientation orientation, const Symmetry& symmetry);

/// The number of points of the pair that are neither released nor mirror images; -1 when the curves differ in kind
/// (degree, knots).
int unlikePoints(const Element& original, const Element& follower, const Symmetry& symmetry);

} // namespace bolster
