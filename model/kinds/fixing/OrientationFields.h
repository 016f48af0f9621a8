// What is said of how a cover leans along a curve on it.
#pragma once

#include "Field.h"
#include "Orientation.h"

namespace bolster {

template <>
struct Description<Orientation> {
    static constexpr const char* verb = QT_TRANSLATE_NOOP("Message", "Change the normal held by %1");

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "normal",
                 .label = QT_TRANSLATE_NOOP("Field", "Direction"),
                 .meaning =
                     "[x, y, z] of any length, or a list of such, spread evenly from the start to the end by "
                     "length and interpolated",
                 .verb = verb,
                 .cost = SolveCost::Retarget},
                Directions{"tangent"}, s...);
        v.field({.key = "normal_weight",
                 .label = QT_TRANSLATE_NOOP("Field", "Weight"),
                 .meaning = "0: not held, 1: nearly exact",
                 .verb = verb,
                 .cost = SolveCost::Refactor},
                Number{0, 100, Unit::None, {.step = 0.1}}, s.weight...);
    }
};

} // namespace bolster
