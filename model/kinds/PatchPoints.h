// The points of patches that elements keep: what cuts, joins or turns patches takes them along.
#pragma once

#include "Element.h"

#include <type_traits>

namespace bolster {

/// Calls visit(PatchPoint&) for each of them; const for an element that is const.
template <class E, class Visit>
void eachPatchPoint(E& element, Visit visit)
{
    std::visit(
        [&](auto& value) {
            using T = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_same_v<T, DrillHole>) {
                visit(value.place);
            } else if constexpr (std::is_same_v<T, Measurement>) {
                visit(value.from);
                visit(value.to);
            }
        },
        element);
}

/// Of the elements with a point of `patch` the new ones: move(PatchPoint&) changes those points.
template <class Elements, class Move, class Take>
void movePatchPoints(const Elements& elements, ElementId patch, Move move, Take take)
{
    for (const auto& [id, element] : elements) {
        bool has = false;
        eachPatchPoint(*element, [&](const PatchPoint& point) { has = has || point.patch == patch; });
        if (!has)
            continue;
        Element moved = *element;
        eachPatchPoint(moved, [&](PatchPoint& point) {
            if (point.patch == patch)
                move(point);
        });
        take(id, makeElement(std::move(moved)));
    }
}

} // namespace bolster
