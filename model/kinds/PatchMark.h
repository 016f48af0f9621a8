// What lies on one patch and means the same where the mirror shows it: trims of edges, and what cutters need there.
#pragma once

#include "Element.h"

#include <type_traits>

namespace bolster {

template <class T>
concept PatchMark = std::is_same_v<T, OutlineTrim> || std::is_same_v<T, EdgeAllowance> ||
    std::is_same_v<T, CutCorner> || std::is_same_v<T, Notch> || std::is_same_v<T, DrillHole>;

/// Where it lies: a Stretch or an OutlinePlace of the outline, or a PatchPoint inside.
template <class T>
auto& whereOf(T& mark)
{
    if constexpr (requires { mark.stretch; })
        return mark.stretch;
    else
        return mark.place;
}

/// Calls visit.template operator()<T>() for each of these kinds.
template <class Visit>
void eachMarkKind(Visit visit)
{
    visit.template operator()<OutlineTrim>();
    visit.template operator()<EdgeAllowance>();
    visit.template operator()<CutCorner>();
    visit.template operator()<Notch>();
    visit.template operator()<DrillHole>();
}

/// Calls visit(mark) if the element is one of them.
template <class Visit>
void visitMark(const Element& element, Visit visit)
{
    std::visit(
        [&]<class T>(const T& value) {
            if constexpr (PatchMark<T>)
                visit(value);
        },
        element);
}

} // namespace bolster
