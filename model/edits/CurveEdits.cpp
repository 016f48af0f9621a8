#include "CurveEdits.h"

#include "EditHelpers.h"

namespace bolster::edits {

namespace {

Edit withCurve(const Design& design, ElementId id, std::optional<BSpline3> curve, Message verb)
{
    const auto* fixation = design.find<FixationCurve>(id);
    if (!fixation || !curve)
        return {};
    FixationCurve changed = *fixation;
    changed.curve = std::move(*curve);
    return replaceWith(design, id, std::move(changed), std::move(verb));
}

} // namespace

Edit moveCurvePoints(const Design& design, ElementId curve, std::span<const int> points, const Vec3& delta)
{
    const auto* fixation = design.find<FixationCurve>(curve);
    if (!fixation)
        return {};
    return withCurve(design, curve, withMovedPoints(fixation->curve, points, delta),
                     moveVerb(points.size(), displayName(design, curve)));
}

Edit insertCurvePoint(const Design& design, ElementId curve, double parameter)
{
    const auto* fixation = design.find<FixationCurve>(curve);
    if (!fixation || !std::isfinite(parameter) || fixation->curve.pointCount() >= mostCurvePoints)
        return {};
    return withCurve(design, curve, fixation->curve.withKnot(parameter), insertVerb(displayName(design, curve)));
}

Edit removeCurvePoint(const Design& design, ElementId curve, int point)
{
    const auto* fixation = design.find<FixationCurve>(curve);
    if (!fixation || point < 0 || point >= fixation->curve.pointCount())
        return {};
    return withCurve(design, curve, fixation->curve.withoutPoint(point), removeVerb(displayName(design, curve)));
}

} // namespace bolster::edits
