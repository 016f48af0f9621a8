#include "PatchEdits.h"

#include "EditHelpers.h"

#include <cmath>
#include <numbers>

namespace bolster::edits {

namespace {

Edit withOutline(const Design& design, ElementId id, std::optional<BSpline2> outline, Message verb)
{
    const auto* patch = design.find<Patch>(id);
    if (!patch || !outline)
        return {};
    Patch changed = *patch;
    changed.outline = std::move(*outline);
    return replaceWith(design, id, std::move(changed), std::move(verb));
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

Edit movePatchPoints(const Design& design, ElementId patch, std::span<const int> points, const Vec2& delta)
{
    const auto* found = design.find<Patch>(patch);
    if (!found)
        return {};
    return withOutline(design, patch, withMovedPoints(found->outline, points, delta),
                       moveVerb(points.size(), displayName(design, patch)));
}

Edit insertPatchPoint(const Design& design, ElementId patch, double parameter)
{
    const auto* found = design.find<Patch>(patch);
    if (!found || !std::isfinite(parameter) || found->outline.pointCount() >= mostCurvePoints)
        return {};
    return withOutline(design, patch, found->outline.withKnot(parameter), insertVerb(displayName(design, patch)));
}

Edit removePatchPoint(const Design& design, ElementId patch, int point)
{
    const auto* found = design.find<Patch>(patch);
    if (!found || point < 0 || point >= found->outline.pointCount())
        return {};
    return withOutline(design, patch, found->outline.withoutPoint(point), removeVerb(displayName(design, patch)));
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
