// What is said of each field of a drill hole.
#pragma once

#include "DrillHole.h"
#include "PatchPointFields.h"

namespace bolster {

template <>
struct Description<DrillHole> {
    static constexpr const char* word = "drill_hole";
    static constexpr KindNames names{78, QT_TRANSLATE_NOOP("ElementText", "Drill hole"),
                                     QT_TRANSLATE_NOOP("ElementText", "Drill holes"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 drill holes"), "drill-hole"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add drill hole %1");
    static SolveCost comes(const DrillHole&) { return SolveCost::Nothing; }

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field(nameField, Text{}, s.name...);
        v.part({}, s.place...);
        v.field({.key = "diameter_mm",
                 .label = QT_TRANSLATE_NOOP("Field", "Diameter"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the diameter of %1")},
                Number{0.1, 100, Unit::Millimetres, {.step = 0.5}}, s.diameter...);
        v.field(noteField, Text{}, s.note...);
    }
};

} // namespace bolster
