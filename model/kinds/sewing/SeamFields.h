// What is said of each field of a seam.
#pragma once

#include "Seam.h"
#include "TrimFields.h"

namespace bolster {

template <>
struct Description<Seam> {
    static constexpr const char* word = "seam";
    static constexpr KindNames names{20, QT_TRANSLATE_NOOP("ElementText", "Seam"),
                                     QT_TRANSLATE_NOOP("ElementText", "Seams"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 seams"), "seam"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add a seam");
    static SolveCost comes(const Seam&) { return SolveCost::Resew; }

    static constexpr const char* continuities[] = {"C0", "C1", "G1"};
    static constexpr const char* continuityLabels[] = {QT_TRANSLATE_NOOP("Field", "C0 \u2013 an edge"),
                                                       QT_TRANSLATE_NOOP("Field", "C1 \u2013 smooth, texture too"),
                                                       QT_TRANSLATE_NOOP("Field", "G1 \u2013 rounded")};

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.group({.key = "a",
                 .label = QT_TRANSLATE_NOOP("Field", "First stretch"),
                 .cost = SolveCost::Resew,
                 .presence = Presence::Required},
                s.a...);
        v.group({.key = "b",
                 .label = QT_TRANSLATE_NOOP("Field", "Second stretch"),
                 .meaning = "on the patch of the first one they must not overlap",
                 .cost = SolveCost::Resew,
                 .presence = Presence::Required},
                s.b...);
        v.field({.key = "reversed",
                 .label = QT_TRANSLATE_NOOP("Field", "Second side runs backwards"),
                 .meaning = "`b` is walked backwards",
                 .verb = QT_TRANSLATE_NOOP("Message", "Reverse %1"),
                 .cost = SolveCost::Resew},
                Flag{}, s.reversed...);
        describeMatch(v, SolveCost::Resew, s.match...);
        v.field({.key = "continuity",
                 .label = QT_TRANSLATE_NOOP("Field", "Continuity"),
                 .meaning = "a sharp edge; smooth, the texture runs on; smooth, the texture need not",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the continuity of %1"),
                 .cost = SolveCost::Refactor},
                Words{continuities, continuityLabels}, s.continuity...);
        v.group(trimField, s.trim...);
        v.field(
            {.key = "ease_mm",
             .label = QT_TRANSLATE_NOOP("Field", "Ease wanted"),
             .meaning = "how much longer than the first side the second one shall be; checked before cutting",
             .tip = QT_TRANSLATE_NOOP("Field", "How much longer the second side shall be than the first one: it "
                                               "is gathered when it is sewn."),
             .verb = QT_TRANSLATE_NOOP("Message", "Change the ease of %1")},
            Number{-1000, 1000, Unit::Millimetres, {.step = 1, .decimals = 2}}, s.ease...);
        v.field({.key = "zip",
                 .label = QT_TRANSLATE_NOOP("Field", "With a zip"),
                 .meaning = "a zip joins its sides; the sewing sheet tells its length",
                 .tip = QT_TRANSLATE_NOOP("Field", "A zip joins the two sides; the sewing sheet tells its length."),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the zip of %1")},
                Flag{}, s.zip...);
        v.field({.key = "sewing_step",
                 .label = QT_TRANSLATE_NOOP("Field", "Step in sewing"),
                 .meaning = "seams with a number are sewn first, by it; the order of the others is proposed",
                 .tip = QT_TRANSLATE_NOOP("Field", "Seams with a number are sewn first, smaller ones before larger "
                                                   "ones. 0: as the program proposes it."),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change when %1 is sewn")},
                Number{0, 100000, Unit::None, {.decimals = 0}}, s.step...);
        v.field(noteField, Text{}, s.note...);
    }
};

} // namespace bolster
