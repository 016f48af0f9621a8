// What is said of each field of a stretch, and of how two are matched.
#pragma once

#include "Field.h"
#include "Stretch.h"

namespace bolster {

struct Patch;

template <>
struct Description<Stretch> {
    static constexpr const char* section = "a [stretch](#stretches)";
    static constexpr const char* wrong =
        QT_TRANSLATE_NOOP("Message", "must be a stretch in braces, with patch, from and to");

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "patch", .label = QT_TRANSLATE_NOOP("Field", "Patch"), .presence = Presence::Required},
                Refers<Patch>{}, s.patch...);
        v.field({.key = "from", .label = QT_TRANSLATE_NOOP("Field", "Begins at"), .presence = Presence::Required},
                Number{.checked = false}, s.from...);
        v.field({.key = "to", .label = QT_TRANSLATE_NOOP("Field", "Ends at"), .presence = Presence::Required},
                Number{.checked = false}, s.to...);
    }
};

inline constexpr const char* matchKeys[] = {"length", "parameter"};
inline constexpr const char* matchLabels[] = {QT_TRANSLATE_NOOP("Field", "By length"),
                                              QT_TRANSLATE_NOOP("Field", "By parameter")};

template <class V, class... S>
void describeMatch(V& v, SolveCost cost, S&... match)
{
    v.field({.key = "match",
             .label = QT_TRANSLATE_NOOP("Field", "Match"),
             .meaning = "which points of two joined stretches belong together",
             .verb = QT_TRANSLATE_NOOP("Message", "Change how %1 is matched"),
             .cost = cost},
            Words{matchKeys, matchLabels}, match...);
}

} // namespace bolster
