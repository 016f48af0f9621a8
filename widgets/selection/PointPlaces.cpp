#include "PointPlaces.h"

#include "CurveEdits.h"
#include "ElementText.h"
#include "PatchEdits.h"
#include "SelectionEdits.h"

#include <array>
#include <set>

namespace bolster {

namespace {

/// The patch in whose coordinates the element's curve is given, or null.
const Patch* patchWith(const Design& design, ElementId id)
{
    const ElementPtr element = design.element(id);
    const PatchCurve* drawn = element ? patchCurve(*element) : nullptr;
    return design.find<Patch>(drawn ? drawn->patch : id);
}

std::optional<Vec2> placeInLayout(const Design& design, const Selection::Point& point)
{
    const int index = planePoint(design, point);
    const Patch* patch = patchWith(design, point.first);
    if (index < 0 || !patch)
        return std::nullopt;
    return toLayout(*patch, planeCurve(*design.element(point.first))->points()[static_cast<std::size_t>(index)]);
}

std::optional<Vec3> placeInSpace(const Design& design, const Selection::Point& point)
{
    const int index = spacePoint(design, point);
    if (index < 0)
        return std::nullopt;
    return spaceCurve(*design.element(point.first))->points()[static_cast<std::size_t>(index)];
}

/// All of them as one edit; `count` points have moved.
Edit moved(const Design& from, const Design& to, const std::set<ElementId>& elements, std::size_t count)
{
    const std::string number = std::to_string(count);
    if (elements.size() != 1)
        return editBetween(from, to, {QT_TRANSLATE_NOOP("Message", "Move %1 points"), {number}});
    const std::string name = displayName(from, *elements.begin()).toStdString();
    return editBetween(from, to,
                       count == 1 ? Message{QT_TRANSLATE_NOOP("Message", "Move a point of %1"), {name}}
                                  : Message{QT_TRANSLATE_NOOP("Message", "Move %2 points of %1"), {name, number}});
}

/// Moves each point for itself: they come from different places.
template <class Delta, class Move>
Edit moveEach(const Design& design, const Selection::Points& points, Delta delta, Move move)
{
    Design now = design;
    std::set<ElementId> elements;
    std::size_t count = 0;
    for (const Selection::Point& point : points) {
        const auto by = delta(point);
        const Edit edit = by ? move(now, point, *by) : Edit{};
        if (edit.empty())
            continue;
        now = now.with(edit);
        elements.insert(point.first);
        ++count;
    }
    return moved(design, now, elements, count);
}

} // namespace

std::vector<Vec2> placesInLayout(const Design& design, const Selection::Points& points)
{
    std::vector<Vec2> places;
    for (const Selection::Point& point : points)
        if (const std::optional<Vec2> place = placeInLayout(design, point))
            places.push_back(*place);
    return places;
}

std::vector<Vec3> placesInSpace(const Design& design, const Selection::Points& points)
{
    std::vector<Vec3> places;
    for (const Selection::Point& point : points)
        if (const std::optional<Vec3> place = placeInSpace(design, point))
            places.push_back(*place);
    return places;
}

Edit placeInLayout(const Design& design, const Selection::Points& points, int axis, double value)
{
    const auto delta = [&](const Selection::Point& point) -> std::optional<Vec2> {
        const std::optional<Vec2> place = placeInLayout(design, point);
        if (!place)
            return std::nullopt;
        const Patch& patch = *patchWith(design, point.first);
        Vec2 there = *place;
        there[axis] = value;
        return Vec2(fromLayout(patch, there) - fromLayout(patch, *place));
    };
    return moveEach(design, points, delta, [](const Design& now, const Selection::Point& point, const Vec2& by) {
        return edits::movePatchPoints(now, point.first, std::array{point.second}, by);
    });
}

Edit placeInSpace(const Design& design, const Selection::Points& points, int axis, double value)
{
    const auto delta = [&](const Selection::Point& point) -> std::optional<Vec3> {
        const std::optional<Vec3> place = placeInSpace(design, point);
        if (!place)
            return std::nullopt;
        Vec3 by = Vec3::Zero();
        by[axis] = value - (*place)[axis];
        return by;
    };
    return moveEach(design, points, delta, [](const Design& now, const Selection::Point& point, const Vec3& by) {
        return edits::moveCurvePoints(now, point.first, std::array{spacePoint(now, point)}, by);
    });
}

} // namespace bolster
