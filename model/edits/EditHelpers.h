// What the editing rules share. Private to the library.
#pragma once

#include "ElementEdits.h"
#include "SpokenName.h"

#include <cmath>
#include <set>

namespace bolster::edits {

/// The element's name, or its label if it has none: for verbs.
inline std::string displayName(const Design& design, ElementId id)
{
    return spokenName(design, id);
}

/// Replaces an element by a changed copy; empty when nothing changed.
template <class T>
Edit replaceWith(const Design& design, ElementId id, T value, Message verb)
{
    return replaceElement(design, id, makeElement(std::move(value)), std::move(verb));
}

/// The outline, handle or fancy seam as a curve in the pattern, alive as long as the design; null for anything
/// else.
inline const BSpline2* curveInPattern(const Design& design, ElementId id)
{
    const ElementPtr element = design.element(id);
    return element ? planeCurve(*element) : nullptr;
}

/// Gives the element another curve; empty without one.
inline Edit replaceCurve(const Design& design, ElementId id, std::optional<BSpline2> curve, Message verb)
{
    if (!curve)
        return {};
    return replaceElement(design, id, withPlaneCurve(*design.element(id), std::move(*curve)), std::move(verb));
}

/// The curve with some control points moved, or nothing if a point would leave the sensible range.
template <int Dim>
std::optional<BSpline<Dim>> withMovedPoints(const BSpline<Dim>& curve, std::span<const int> indices,
                                            const typename BSpline<Dim>::Point& delta)
{
    auto points = curve.points();
    for (const int i : std::set<int>(indices.begin(), indices.end()))
        if (i >= 0 && i < curve.pointCount())
            points[static_cast<std::size_t>(i)] += delta;
    if (BSpline<Dim>::problem(curve.degree(), curve.closed(), points, curve.knots()))
        return std::nullopt;
    return curve.withPoints(std::move(points));
}

inline Message moveVerb(std::size_t count, const std::string& name)
{
    if (count == 1)
        return {QT_TRANSLATE_NOOP("Message", "Move a point of %1"), {name}};
    return {QT_TRANSLATE_NOOP("Message", "Move %2 points of %1"), {name, std::to_string(count)}};
}

inline Message insertVerb(const std::string& name)
{
    return {QT_TRANSLATE_NOOP("Message", "Insert a point into %1"), {name}};
}

inline Message removeVerb(const std::string& name)
{
    return {QT_TRANSLATE_NOOP("Message", "Remove a point of %1"), {name}};
}

} // namespace bolster::edits
