// What is said of each field of the settings.
#pragma once

#include "Field.h"
#include "PieceCuttingFields.h"
#include "Settings.h"

namespace bolster {

struct Colourway;

template <>
struct Description<Symmetry> {
    static constexpr const char* section = "see [twins](#twins)";
    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.within({.key = "plane", .meaning = "in space"}, [&](auto& plane) {
            plane.field({.key = "point", .meaning = "mm"}, Direction{}, s.planePoint...);
            plane.field({.key = "normal", .meaning = "of any length"}, Direction{}, s.planeNormal...);
        });
        v.within({.key = "axis", .meaning = "in the layout; only for show, and for where new twins lie"},
                 [&](auto& axis) {
                     axis.field({.key = "point", .meaning = "mm"}, Direction{}, s.axisPoint...);
                     axis.field({.key = "direction", .meaning = "of any length"}, Direction{}, s.axisDirection...);
                 });
    }
};

template <>
struct Description<Settings> {
    static constexpr const char* word = "settings";
    static constexpr KindNames names{1000, QT_TRANSLATE_NOOP("ElementText", "Design"),
                                     QT_TRANSLATE_NOOP("ElementText", "Design"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 elements"), "settings"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Change the settings");
    static SolveCost comes(const Settings&) { return SolveCost::Resew; }

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field(
            {.key = "edge_length",
             .label = QT_TRANSLATE_NOOP("Field", "Mesh edges"),
             .meaning = "mean edge of the triangulation, > 0; not so small that the patches need more than 5 "
                        "million triangles",
             .tip = QT_TRANSLATE_NOOP("Field", "How long the edges of the triangles are: shorter ones show smaller "
                                               "folds, and take longer."),
             .verb = QT_TRANSLATE_NOOP("Message", "Change the settings"),
             .cost = SolveCost::Rebuild,
             .presence = Presence::Always},
            Number{0, 1e7, Unit::Millimetres, {.least = 0.1, .most = 1000}, false}, s.edgeLength...);
        v.group({.key = "symmetry",
                 .label = QT_TRANSLATE_NOOP("Field", "Symmetry"),
                 .meaning = "where the mirrors of twins are"},
                s.symmetry...);
        v.field({.key = "colourway",
                 .label = QT_TRANSLATE_NOOP("Field", "Colourway shown"),
                 .meaning = "the one that is shown; without it each patch shows its own fabric",
                 .without = QT_TRANSLATE_NOOP("Field", "as made")},
                Refers<Colourway>{Need::Shown, false}, s.colourway...);
        v.group(cuttingField, s.cutting...);
    }
};

} // namespace bolster
