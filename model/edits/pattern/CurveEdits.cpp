#include "CurveEdits.h"

#include "EditHelpers.h"

namespace bolster::edits {

namespace {

Edit withFixation(const Design& design, ElementId id, std::optional<BSpline3> curve, Message verb)
{
    if (!curve)
        return {};
    return replaceElement(design, id, withSpaceCurve(*design.element(id), std::move(*curve)), std::move(verb));
}

const BSpline3* fixationOf(const Design& design, ElementId id)
{
    const ElementPtr element = design.element(id);
    return element ? spaceCurve(*element) : nullptr; // alive as long as the design
}

} // namespace

Edit moveCurvePoints(const Design& design, ElementId id, std::span<const int> points, const Vec3& delta)
{
    const BSpline3* curve = fixationOf(design, id);
    if (!curve)
        return {};
    return withFixation(design, id, withMovedPoints(*curve, points, delta),
                        moveVerb(points.size(), displayName(design, id)));
}

Edit insertCurvePoint(const Design& design, ElementId id, double parameter)
{
    const BSpline3* curve = fixationOf(design, id);
    if (!curve || !std::isfinite(parameter) || curve->pointCount() >= mostCurvePoints)
        return {};
    return withFixation(design, id, curve->withKnot(parameter), insertVerb(displayName(design, id)));
}

Edit removeCurvePoint(const Design& design, ElementId id, int point)
{
    const BSpline3* curve = fixationOf(design, id);
    if (!curve || point < 0 || point >= curve->pointCount())
        return {};
    return withFixation(design, id, curve->withoutPoint(point), removeVerb(displayName(design, id)));
}

} // namespace bolster::edits
