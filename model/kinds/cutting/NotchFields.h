// What is said of each field of notches.
#pragma once

#include "AllowanceFields.h"
#include "Notch.h"

namespace bolster {

template <>
struct Description<NotchShape> {
    static constexpr const char* section = "see [cutting](#cutting)";
    static constexpr const char* verb = QT_TRANSLATE_NOOP("Message", "Change the notches of %1");
    static constexpr const char* kinds[] = {"slit", "v", "t", "castle", "u"};
    static constexpr const char* kindLabels[] = {
        QT_TRANSLATE_NOOP("Field", "Slit"), QT_TRANSLATE_NOOP("Field", "V"), QT_TRANSLATE_NOOP("Field", "T"),
        QT_TRANSLATE_NOOP("Field", "Castle"), QT_TRANSLATE_NOOP("Field", "U")};

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "kind", .label = QT_TRANSLATE_NOOP("Field", "Notch"), .verb = verb},
                Words{kinds, kindLabels}, s.kind...);
        v.field({.key = "depth_mm",
                 .label = QT_TRANSLATE_NOOP("Field", "Depth"),
                 .meaning = "from the cut line towards the sewing line",
                 .verb = verb,
                 .alone = QT_TRANSLATE_NOOP("Field", "Depth of notches")},
                Number{0.5, 50, Unit::Millimetres, {.step = 0.5}}, s.depth...);
        v.field({.key = "width_mm",
                 .label = QT_TRANSLATE_NOOP("Field", "Width"),
                 .meaning = "along the cut line; a slit has none",
                 .verb = verb,
                 .alone = QT_TRANSLATE_NOOP("Field", "Width of notches")},
                Number{0.5, 50, Unit::Millimetres, {.step = 0.5}}, s.width...);
    }
};

inline constexpr Field notchShapeField{.key = "shape", .label = QT_TRANSLATE_NOOP("Field", "Shape")};

inline constexpr Number notchSpacing{0, 10000, Unit::Millimetres, {.step = 10}};

template <>
struct Description<AutomaticNotches> {
    static constexpr const char* section = "see [cutting](#cutting)";
    static constexpr const char* verb = QT_TRANSLATE_NOOP("Message", "Change the automatic notches");

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.group(notchShapeField, s.shape...);
        v.field({.key = "spacing_mm",
                 .label = QT_TRANSLATE_NOOP("Field", "Notches along seams every"),
                 .meaning = "at most so far apart along a seam, evenly; 0: none between its ends",
                 .verb = verb},
                notchSpacing, s.spacing...);
        v.field({.key = "ends",
                 .label = QT_TRANSLATE_NOOP("Field", "Notches at ends of seams"),
                 .meaning = "where a seam ends inside an edge, and where fancy seams meet the outline",
                 .verb = verb},
                Flag{}, s.ends...);
        v.field(
            {.key = "telling",
             .label = QT_TRANSLATE_NOOP("Field", "Notches that tell halves apart"),
             .meaning = "on seams that could be sewn the wrong way round, two side by side nearer to their start",
             .verb = verb},
            Flag{}, s.telling...);
    }
};

template <>
struct Description<Notch> {
    static constexpr const char* word = "notch";
    static constexpr KindNames names{76, QT_TRANSLATE_NOOP("ElementText", "Notch"),
                                     QT_TRANSLATE_NOOP("ElementText", "Notches"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 notches"), "notch"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add a notch");
    static SolveCost comes(const Notch&) { return SolveCost::Nothing; }

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.part({}, s.place...);
        v.group(notchShapeField, s.shape...);
        v.field({.key = "twice",
                 .label = QT_TRANSLATE_NOOP("Field", "Two side by side"),
                 .meaning = "to tell front from back",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the notches of %1")},
                Flag{}, s.twice...);
        v.field(noteField, Text{}, s.note...);
    }
};

} // namespace bolster
