#include "PatchEdits.h"

#include "EditHelpers.h"

#include <cmath>
#include <numbers>

namespace bolster::edits {

namespace {

Edit withCurve(const Design& design, ElementId id, std::optional<BSpline2> curve, Message verb)
{
    if (!curve)
        return {};
    return replaceElement(design, id, withPlaneCurve(*design.element(id), std::move(*curve)), std::move(verb));
}

const BSpline2* curveOf(const Design& design, ElementId id)
{
    const ElementPtr element = design.element(id);
    return element ? planeCurve(*element) : nullptr; // alive as long as the design
}

// Changes the place of each patch by place(Patch&).
template <class Place>
Edit replaced(const Design& design, std::span<const ElementId> patches, Place place, Message verb)
{
    Edit edit{std::move(verb), {}};
    for (const ElementId id : std::set<ElementId>(patches.begin(), patches.end())) {
        const auto* patch = design.find<Patch>(id);
        if (!patch)
            continue;
        Patch changed = *patch;
        place(changed);
        const bool sensible = changed.position.allFinite() && std::isfinite(changed.rotation);
        if (sensible && !(changed == *patch))
            edit.changes.push_back({id, design.element(id), makeElement(std::move(changed))});
    }
    return edit.empty() ? Edit{} : edit;
}

} // namespace

Edit movePatchPoints(const Design& design, ElementId id, std::span<const int> points, const Vec2& delta)
{
    const BSpline2* curve = curveOf(design, id);
    if (!curve)
        return {};
    return withCurve(design, id, withMovedPoints(*curve, points, delta),
                     moveVerb(points.size(), displayName(design, id)));
}

Edit insertPatchPoint(const Design& design, ElementId id, double parameter)
{
    const BSpline2* curve = curveOf(design, id);
    if (!curve || !std::isfinite(parameter) || curve->pointCount() >= mostCurvePoints)
        return {};
    return withCurve(design, id, curve->withKnot(parameter), insertVerb(displayName(design, id)));
}

Edit removePatchPoint(const Design& design, ElementId id, int point)
{
    const BSpline2* curve = curveOf(design, id);
    if (!curve || point < 0 || point >= curve->pointCount())
        return {};
    return withCurve(design, id, curve->withoutPoint(point), removeVerb(displayName(design, id)));
}

Edit movePatches(const Design& design, std::span<const ElementId> patches, const Vec2& delta)
{
    Message verb{QT_TRANSLATE_NOOP("Message", "Move %1 patches"), {std::to_string(patches.size())}};
    if (patches.size() == 1)
        verb = {QT_TRANSLATE_NOOP("Message", "Move %1"), {displayName(design, patches.front())}};
    return replaced(
        design, patches, [&](Patch& patch) { patch.position += delta; }, std::move(verb));
}

Edit turnPatches(const Design& design, std::span<const ElementId> patches, const Vec2& centre, double degrees)
{
    Message verb{QT_TRANSLATE_NOOP("Message", "Turn %1 patches"), {std::to_string(patches.size())}};
    if (patches.size() == 1)
        verb = {QT_TRANSLATE_NOOP("Message", "Turn %1"), {displayName(design, patches.front())}};
    const Eigen::Rotation2Dd turn(degrees * std::numbers::pi / 180);
    const auto place = [&](Patch& patch) {
        if (degrees == 0)
            return;
        patch.position = centre + turn * (patch.position - centre);
        patch.rotation = std::remainder(patch.rotation + degrees, 360);
    };
    return replaced(design, patches, place, std::move(verb));
}

} // namespace bolster::edits
