// What is said of each field of a place inside a patch.
#pragma once

#include "Field.h"
#include "PatchPoint.h"

namespace bolster {

struct Patch;

template <>
struct Description<PatchPoint> {
    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "patch", .label = QT_TRANSLATE_NOOP("Field", "Patch"), .presence = Presence::Required},
                Refers<Patch>{}, s.patch...);
        v.field({.key = "position",
                 .label = QT_TRANSLATE_NOOP("Field", "Position"),
                 .meaning = "in outline coordinates",
                 .verb = QT_TRANSLATE_NOOP("Message", "Move %1"),
                 .presence = Presence::Required},
                Coordinates{.box = {.decimals = 3}}, s.position...);
    }
};

} // namespace bolster
