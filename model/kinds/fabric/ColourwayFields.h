// What is said of each field of a colourway.
#pragma once

#include "Colourway.h"
#include "Field.h"

namespace bolster {

struct Fabric;
struct Patch;

/// An entry whose patch or fabric is gone goes, too; the colourway stays.
template <>
struct Description<Colourway::Entry> {
    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "patch", .label = QT_TRANSLATE_NOOP("Field", "Patch"), .presence = Presence::Required},
                Refers<Patch>{Need::Shown}, s.patch...);
        v.field({.key = "fabric", .label = QT_TRANSLATE_NOOP("Field", "Fabric"), .presence = Presence::Required},
                Refers<Fabric>{Need::Seen}, s.fabric...);
    }
};

template <>
struct Description<Colourway> {
    static constexpr const char* word = "colourway";
    static constexpr KindNames names{130, QT_TRANSLATE_NOOP("ElementText", "Colourway"),
                                     QT_TRANSLATE_NOOP("ElementText", "Colourways"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 colourways"), "colourway"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add colourway %1");
    static SolveCost comes(const Colourway&) { return SolveCost::Nothing; }

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field(nameField, Text{}, s.name...);
        v.list(
            {.key = "fabrics",
             .label = QT_TRANSLATE_NOOP("Field", "Fabrics"),
             .meaning =
                 "a list of `{\"patch\": 2, \"fabric\": 10}`, each patch at most once; the other patches show "
                 "their own fabric"},
            Entries{.wrongList =
                        QT_TRANSLATE_NOOP("Message", "must be a list of pairs in braces, with patch and fabric"),
                    .wrongEntry = QT_TRANSLATE_NOOP("Message", "must be a pair in braces, with patch and fabric"),
                    .mayBeEmpty = false},
            s.fabrics...);
        v.field(noteField, Text{}, s.note...);
    }
};

} // namespace bolster
