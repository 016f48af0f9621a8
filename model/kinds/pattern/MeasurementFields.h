// What is said of each field of a measurement.
#pragma once

#include "Measurement.h"
#include "PatchPointFields.h"

namespace bolster {

template <>
struct Description<Measurement> {
    static constexpr const char* word = "measurement";
    static constexpr KindNames names{79, QT_TRANSLATE_NOOP("ElementText", "Measurement"),
                                     QT_TRANSLATE_NOOP("ElementText", "Measurements"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 measurements"), "measure"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add measurement %1");
    static SolveCost comes(const Measurement&) { return SolveCost::Nothing; }

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field(nameField, Text{}, s.name...);
        v.group({.key = "from",
                 .label = QT_TRANSLATE_NOOP("Field", "From"),
                 .meaning = "a point of the cover",
                 .presence = Presence::Required},
                s.from...);
        v.group({.key = "to",
                 .label = QT_TRANSLATE_NOOP("Field", "To"),
                 .meaning = "another one, of the same patch or of another",
                 .presence = Presence::Required},
                s.to...);
        v.field(noteField, Text{}, s.note...);
    }
};

} // namespace bolster
