#include "PatchEdits.h"

#include "EditHelpers.h"

#include <cmath>
#include <numbers>

namespace bolster::edits {

namespace {

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
    const BSpline2* curve = curveInPattern(design, id);
    if (!curve)
        return {};
    return replaceCurve(design, id, withMovedPoints(*curve, points, delta),
                        moveVerb(points.size(), displayName(design, id)));
}

Edit insertPatchPoint(const Design& design, ElementId id, double parameter)
{
    const BSpline2* curve = curveInPattern(design, id);
    if (!curve || !std::isfinite(parameter) || curve->pointCount() >= mostCurvePoints)
        return {};
    return replaceCurve(design, id, curve->withKnot(parameter), insertVerb(displayName(design, id)));
}

Edit removePatchPoint(const Design& design, ElementId id, int point)
{
    const BSpline2* curve = curveInPattern(design, id);
    if (!curve || point < 0 || point >= curve->pointCount())
        return {};
    return replaceCurve(design, id, curve->withoutPoint(point), removeVerb(displayName(design, id)));
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
