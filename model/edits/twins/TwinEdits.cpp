#include "TwinEdits.h"

#include "EditHelpers.h"
#include "ElementRules.h"
#include "PatchMark.h"
#include "SewnMirror.h"
#include "Twins.h"

#include <algorithm>

namespace bolster::edits {

namespace {

/// Both twins, the original first; noElement when it has none.
std::pair<ElementId, ElementId> pairOf(const Design& design, ElementId id)
{
    for (const auto& [follower, original] : twinPairs(design))
        if (id == follower || id == original)
            return {original, follower};
    return {noElement, noElement};
}

bool hasPoint(const Element& element, int point)
{
    const BSpline2* plane = planeCurve(element);
    const BSpline3* space = spaceCurve(element);
    const int first = plane ? firstTwinSpacePoint : 0;
    return (plane && point >= 0 && point < plane->pointCount()) ||
           (space && point >= first && point < first + space->pointCount());
}

Edit changeReleased(const Design& design, ElementId follower, const std::set<int>& released, Message verb)
{
    const ElementPtr element = design.element(follower);
    Twin link = *twinLink(*element);
    link.released.assign(released.begin(), released.end());
    return replaceElement(design, follower, withTwinLink(*element, std::move(link)), std::move(verb));
}

/// The element with these points where the mirror shows those of its twin.
ElementPtr withMirrored(const Element& element, const Element& twin, const std::set<int>& points,
                        const Symmetry& symmetry)
{
    Element result = element;
    const auto place = [&](auto curve, const auto& image, int first) {
        auto places = curve.points();
        for (const int point : points)
            if (point >= first && point < first + std::min(curve.pointCount(), image.pointCount()))
                places[static_cast<std::size_t>(point - first)] =
                    image.points()[static_cast<std::size_t>(point - first)];
        return curve.withPoints(std::move(places));
    };
    const BSpline2* plane = planeCurve(element);
    if (plane)
        if (const auto image = mirroredCurve(*planeCurve(twin)))
            result = *withPlaneCurve(result, place(*plane, *image, 0));
    if (const BSpline3* space = spaceCurve(element); space && !space->empty())
        if (const auto image = mirroredCurve(*spaceCurve(twin), symmetry))
            result = *withSpaceCurve(result, place(*space, *image, plane ? firstTwinSpacePoint : 0));
    return std::make_shared<const Element>(std::move(result));
}

bool meet(const Design& design, const Stretch& a, const Stretch& b)
{
    const auto* patch = design.find<Patch>(a.patch);
    return patch && a.patch == b.patch && stretchesOverlap(patch->outline, a, b);
}

/// Which way round two seams lie in the same place; nothing when they don't.
std::optional<bool> meetSwapped(const Design& design, const Seam& a, const Seam& b)
{
    if (meet(design, a.a, b.a) && meet(design, a.b, b.b))
        return false;
    return meet(design, a.a, b.b) && meet(design, a.b, b.a) ? std::optional(true) : std::nullopt;
}

/// The mirror image of what lies where the mirror shows this one.
std::optional<Seam> imageThere(const Design& design, const SewnMirror& mirror, ElementId id, const Seam& seam)
{
    const auto place = mirror.of(seam);
    std::optional<Seam> result;
    design.each<Seam>([&](ElementId other, const Seam& there) {
        const auto swapped = place && other != id && !result ? meetSwapped(design, *place, there) : std::nullopt;
        if (!swapped)
            return;
        result = mirror.of(there);
        if (result && *swapped)
            std::swap(result->a, result->b);
        for (Stretch Seam::*side : {&Seam::a, &Seam::b}) // of a piece that is nearly its own mirror image
            if (result && mirror.same((*result).*side, seam.*side))
                (*result).*side = seam.*side;
    });
    return result;
}

std::optional<FixationSeam> imageThere(const Design& design, const SewnMirror& mirror, ElementId id,
                                       const FixationSeam& fixation)
{
    const auto place = mirror.of(fixation.stretch);
    std::optional<FixationSeam> result;
    design.each<FixationSeam>([&](ElementId other, const FixationSeam& there) {
        if (place && other != id && !result && there.hasCurve() == fixation.hasCurve() &&
            meet(design, place->stretch, there.stretch))
            result = mirror.of(there);
    });
    return result;
}

/// Of marks only those along stretches can be somewhere else than their images and still be meant.
template <PatchMark T>
std::optional<T> imageThere(const Design& design, const SewnMirror& mirror, ElementId id, const T& mark)
{
    std::optional<T> result;
    if constexpr (requires { mark.stretch; }) {
        const auto place = mirror.of(mark);
        design.each<T>([&](ElementId other, const T& there) {
            if (place && other != id && !result && meet(design, place->stretch, there.stretch))
                result = mirror.of(there);
        });
    }
    return result;
}

ElementId mirrored(const Design& design, const SewnMirror& mirror, ElementId id)
{
    const ElementPtr element = design.element(id);
    if (const auto* seam = std::get_if<Seam>(element.get()))
        return mirror.counterpart(*seam).id;
    if (const auto* fixation = std::get_if<FixationSeam>(element.get()))
        return mirror.counterpart(*fixation).id;
    ElementId there = mirror.twin(id);
    if (element)
        visitMark(*element, [&](const auto& mark) { there = mirror.counterpart(mark).id; });
    return there;
}

} // namespace

Edit unlinkTwins(const Design& design, std::span<const ElementId> ids)
{
    Edit edit;
    std::set<ElementId> followers;
    for (const ElementId id : ids)
        if (const auto [original, follower] = pairOf(design, id);
            follower != noElement && followers.insert(follower).second)
            edit.changes.push_back(
                {follower, design.element(follower), withTwinLink(*design.element(follower), std::nullopt)});
    if (edit.empty())
        return edit;
    const ElementId first = edit.changes.front().id;
    edit.verb = {QT_TRANSLATE_NOOP("Message", "Unlink %1 and %2"),
                 {displayName(design, twinOf(design, first)), displayName(design, first)}};
    if (followers.size() > 1)
        edit.verb = {QT_TRANSLATE_NOOP("Message", "Unlink %1 pairs of twins"), {std::to_string(followers.size())}};
    return edit;
}

Edit releasePoints(const Design& design, ElementId id, std::span<const int> points)
{
    const ElementId follower = pairOf(design, id).second;
    if (follower == noElement)
        return {};
    const std::vector<int> before = releasedPoints(design, id);
    std::set<int> released(before.begin(), before.end());
    for (const int point : points)
        if (hasPoint(*design.element(id), point))
            released.insert(point);
    const std::size_t count = released.size() - before.size();
    if (count == 1)
        return changeReleased(design, follower, released,
                              {QT_TRANSLATE_NOOP("Message", "Release a point of %1"), {displayName(design, id)}});
    return changeReleased(design, follower, released,
                          {QT_TRANSLATE_NOOP("Message", "Release %2 points of %1"),
                           {displayName(design, id), std::to_string(count)}});
}

Edit relinkPoints(const Design& design, ElementId id, std::span<const int> points)
{
    const auto [original, follower] = pairOf(design, id);
    if (follower == noElement)
        return {};
    const std::vector<int> before = releasedPoints(design, id);
    std::set<int> released(before.begin(), before.end());
    std::set<int> linked;
    for (const int point : points)
        if (released.erase(point) > 0)
            linked.insert(point);
    if (linked.empty())
        return {};
    Message verb{QT_TRANSLATE_NOOP("Message", "Re-link a point of %1"), {displayName(design, id)}};
    if (linked.size() > 1)
        verb = {QT_TRANSLATE_NOOP("Message", "Re-link %2 points of %1"),
                {displayName(design, id), std::to_string(linked.size())}};
    const Element& twin = *design.element(id == original ? follower : original);
    const Design moved =
        design.with({{}, {{id, nullptr, withMirrored(*design.element(id), twin, linked, symmetryOf(design))}}});
    return editBetween(design, moved.with(changeReleased(moved, follower, released, {})), std::move(verb));
}

ElementId mirroredElement(const Design& design, ElementId id)
{
    return mirrored(design, SewnMirror(design, twinPairs(design)), id);
}

std::set<ElementId> mirroredElements(const Design& design, const std::set<ElementId>& ids)
{
    std::set<ElementId> result;
    const SewnMirror mirror(design, ids.empty() ? SewnMirror::Pairs() : twinPairs(design));
    for (const ElementId id : ids)
        if (const ElementId there = mirrored(design, mirror, id); there != noElement && !ids.contains(there))
            result.insert(there);
    return result;
}

bool sewingReleased(const Design& design, ElementId id)
{
    const ElementPtr element = design.element(id);
    return element && SewnMirror(design, twinPairs(design)).released(*element);
}

Edit relinkSewing(const Design& design, ElementId id)
{
    const Message verb{QT_TRANSLATE_NOOP("Message", "Re-link a seam to its mirror image")};
    const SewnMirror mirror(design, twinPairs(design));
    if (const auto* seam = design.find<Seam>(id))
        if (const auto there = imageThere(design, mirror, id, *seam))
            return replaceWith(design, id, *there, verb);
    if (const auto* fixation = design.find<FixationSeam>(id))
        if (const auto there = imageThere(design, mirror, id, *fixation))
            return replaceWith(design, id, *there, verb);
    Edit edit;
    if (const ElementPtr element = design.element(id))
        visitMark(*element, [&](const auto& mark) {
            if (const auto there = imageThere(design, mirror, id, mark))
                edit = replaceWith(design, id, *there, verb);
        });
    return edit;
}

std::vector<int> pointsOnStretch(const BSpline2& outline, double from, double to)
{
    std::vector<int> points;
    const double period = outline.period();
    const double slack = 1e-9 * period;
    const double length = unwrappedEnd(from, to, outline.domainStart(), outline.domainEnd()) - from;
    for (int i = 0; i < outline.pointCount(); ++i) {
        double ahead = outline.parameterOfPoint(i) - from;
        ahead -= period * std::floor((ahead + slack) / period);
        if (ahead <= length + slack)
            points.push_back(i);
    }
    if (points.empty()) // a part of a straight edge
        points = {outline.pointAt(outline.wrapped(from)), outline.pointAt(outline.wrapped(to))};
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

} // namespace bolster::edits
