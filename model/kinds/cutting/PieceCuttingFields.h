// What is said of each field that a cutter needs: of a piece, of a fabric, of the whole pattern.
#pragma once

#include "AllowanceFields.h"
#include "DesignCutting.h"
#include "FabricCutting.h"
#include "NotchFields.h"
#include "PieceCutting.h"

namespace bolster {

inline constexpr Field cuttingField{.key = "cutting", .label = QT_TRANSLATE_NOOP("Field", "Cutting")};

template <>
struct Description<PieceLabelPlace> {
    static constexpr const char* verb = QT_TRANSLATE_NOOP("Message", "Move the label of %1");

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "position",
                 .label = QT_TRANSLATE_NOOP("Field", "Label at"),
                 .meaning = "of its middle, in outline coordinates",
                 .verb = verb,
                 .presence = Presence::Required},
                Coordinates{}, s.position...);
        v.field({.key = "rotation",
                 .label = QT_TRANSLATE_NOOP("Field", "Label turned by"),
                 .meaning = "of its lines, counter-clockwise",
                 .verb = verb},
                Number{-1e7, 1e7, Unit::Degrees, {.step = 15, .decimals = 1, .least = -360, .most = 360}},
                s.rotation...);
    }
};

template <>
struct Description<PieceCutting> {
    static constexpr const char* section = "see [cutting](#cutting)";
    static constexpr const char* verb = QT_TRANSLATE_NOOP("Message", "Change how %1 is cut");
    static constexpr const char* naps[] = {"two_ways", "one_way", "any"};
    static constexpr const char* napLabels[] = {QT_TRANSLATE_NOOP("Field", "Two ways \u2013 either end up"),
                                                QT_TRANSLATE_NOOP("Field", "One way \u2013 one end up"),
                                                QT_TRANSLATE_NOOP("Field", "Any direction")};

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "quantity",
                 .label = QT_TRANSLATE_NOOP("Field", "Quantity"),
                 .meaning = "how often it is cut, a whole number; pairs count as one",
                 .verb = verb},
                Number{1, 1000, Unit::None, {.decimals = 0}}, s.quantity...);
        v.field({.key = "pair",
                 .label = QT_TRANSLATE_NOOP("Field", "Mirrored pair"),
                 .meaning = "cut once as it is and once mirrored",
                 .verb = verb},
                Flag{}, s.pair...);
        v.field({.key = "nap",
                 .label = QT_TRANSLATE_NOOP("Field", "Nap"),
                 .meaning = "which ways round the piece may lie on the fabric",
                 .verb = verb},
                Words{naps, napLabels}, s.nap...);
        v.field({.key = "tolerance",
                 .label = QT_TRANSLATE_NOOP("Field", "Grain may be off by"),
                 .meaning = "how far the grain line may be turned against the fabric's",
                 .verb = verb},
                Number{0, 180, Unit::Degrees, {.step = 1, .decimals = 1}}, s.tolerance...);
        v.field({.key = "note",
                 .label = QT_TRANSLATE_NOOP("Field", "Line on the label"),
                 .meaning = "one more line of the label",
                 .verb = verb},
                Text{}, s.note...);
        v.group({.key = "label",
                 .label = QT_TRANSLATE_NOOP("Field", "Label"),
                 .meaning = "where it stands; without it where it finds room",
                 .without = QT_TRANSLATE_NOOP("Field", "where it finds room")},
                s.label...);
    }
};

template <>
struct Description<FabricCutting> {
    static constexpr const char* section = "see [cutting](#cutting)";
    static constexpr const char* verb = QT_TRANSLATE_NOOP("Message", "Change how %1 is cut");
    static constexpr Number shrinkage{-20, 50, Unit::Percent, {.step = 0.5, .decimals = 2}};

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "width_mm",
                 .label = QT_TRANSLATE_NOOP("Field", "Usable width"),
                 .meaning = "of the fabric from edge to edge",
                 .verb = verb},
                Number{10, 1e5, Unit::Millimetres, {.step = 10, .decimals = 1}}, s.width...);
        v.field({.key = "shrink_along",
                 .label = QT_TRANSLATE_NOOP("Field", "Shrinks along"),
                 .meaning = "of what is cut, until it is worn, along the grain",
                 .tip = QT_TRANSLATE_NOOP("Field", "Pieces are cut so much larger along the grain that they have "
                                                   "their size when the fabric has shrunk."),
                 .verb = verb},
                shrinkage, s.shrinkAlong...);
        v.field({.key = "shrink_across",
                 .label = QT_TRANSLATE_NOOP("Field", "Shrinks across"),
                 .meaning = "the same across the grain",
                 .verb = verb},
                shrinkage, s.shrinkAcross...);
    }
};

template <>
struct Description<DesignCutting> {
    static constexpr const char* section = "see [cutting](#cutting)";
    static constexpr const char* verb = QT_TRANSLATE_NOOP("Message", "Change how the pattern is cut");

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.group({.key = "allowance",
                 .label = QT_TRANSLATE_NOOP("Field", "Seam allowance"),
                 .meaning = "of all patches that have no other; without it whoever exports says it, else 10 mm",
                 .without = QT_TRANSLATE_NOOP("Field", "10 mm")},
                s.allowance...);
        v.group({.key = "notches", .label = QT_TRANSLATE_NOOP("Field", "Automatic notches")}, s.notches...);
        v.field({.key = "style",
                 .label = QT_TRANSLATE_NOOP("Field", "Style"),
                 .meaning = "name of the article; without it the file's name",
                 .verb = verb},
                Text{}, s.style...);
        v.field({.key = "version",
                 .label = QT_TRANSLATE_NOOP("Field", "Version"),
                 .meaning = "for labels and files",
                 .verb = verb},
                Text{}, s.version...);
    }
};

} // namespace bolster
