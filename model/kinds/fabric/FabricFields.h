// What is said of each field of a fabric.
#pragma once

#include "Fabric.h"
#include "Field.h"
#include "PieceCuttingFields.h"

namespace bolster {

template <>
struct Description<FabricLook> {
    static constexpr const char* section = "see [looks](#looks)";
    static constexpr const char* kinds[] = {"plain", "checker", "smooth_leather", "grained_leather",
                                            "woven", "velvet",  "image"};
    static constexpr const char* kindLabels[] = {
        QT_TRANSLATE_NOOP("Field", "Plain"),          QT_TRANSLATE_NOOP("Field", "Checker"),
        QT_TRANSLATE_NOOP("Field", "Smooth leather"), QT_TRANSLATE_NOOP("Field", "Grained leather"),
        QT_TRANSLATE_NOOP("Field", "Woven"),          QT_TRANSLATE_NOOP("Field", "Velvet"),
        QT_TRANSLATE_NOOP("Field", "Picture \u2026")};
    static constexpr const char* verb = QT_TRANSLATE_NOOP("Message", "Change the look of %1");

    static FabricLook usual(const FabricLook& look) { return usualLook(look.kind); }

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "kind",
                 .label = QT_TRANSLATE_NOOP("Field", "Kind"),
                 .meaning = "what it is like; decides the usual values of the others",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the kind of %1")},
                Words{kinds, kindLabels}, s.kind...);
        v.usual(s...);
        v.field({.key = "second_color",
                 .label = QT_TRANSLATE_NOOP("Field", "Second colour"),
                 .meaning = "the checker's other squares, the weft of a weave, the creases of leather; without it "
                            "derived from the fabric's colour",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the second colour of %1")},
                Color{.mayBeEmpty = true}, s.secondColor...);
        v.field({.key = "roughness",
                 .label = QT_TRANSLATE_NOOP("Field", "Roughness"),
                 .meaning = "from polished (0) to matt (1)",
                 .verb = verb},
                Number{0, 1, Unit::None, {.step = 0.05}}, s.roughness...);
        v.field({.key = "scale_mm",
                 .label = QT_TRANSLATE_NOOP("Field", "Scale"),
                 .meaning =
                     "real size of a checker's square, the grain of leather from crease to crease, the repeat "
                     "of a weave, the nap of velvet, the width of an image",
                 .verb = verb},
                Number{0.1, 1e4, Unit::Millimetres}, s.scale...);
        v.field({.key = "rotation",
                 .label = QT_TRANSLATE_NOOP("Field", "Turned from the grain"),
                 .meaning = "against the grain line, counter-clockwise",
                 .verb = verb},
                Number{-1e7, 1e7, Unit::Degrees, {.step = 15, .decimals = 1, .least = -360, .most = 360}},
                s.rotation...);
        v.field({.key = "relief",
                 .label = QT_TRANSLATE_NOOP("Field", "Relief"),
                 .meaning = "strength of the relief, from flat (0)",
                 .verb = verb},
                Number{0, 2, Unit::None, {.step = 0.1}}, s.relief...);
        v.field({.key = "file",
                 .label = QT_TRANSLATE_NOOP("Field", "File"),
                 .meaning = "of an image, by the rules for frames: PNG, JPEG, TIFF or EXR",
                 .counts = ((s.kind == FabricLook::Kind::Image) || ...)},
                FileName{}, s.file...);
    }
};

inline constexpr Number strainLimit{0.1, 200, Unit::Percent, {.step = 1, .decimals = 1}};

template <>
struct Description<StretchLimits> {
    static constexpr const char* verb = QT_TRANSLATE_NOOP("Message", "Change the limits of %1");

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "along",
                 .label = QT_TRANSLATE_NOOP("Field", "Most along the grain"),
                 .meaning = "strain along the grain",
                 .verb = verb},
                strainLimit, s.along...);
        v.field({.key = "across",
                 .label = QT_TRANSLATE_NOOP("Field", "Most across"),
                 .meaning = "strain across the grain",
                 .verb = verb},
                strainLimit, s.across...);
        v.field({.key = "shear",
                 .label = QT_TRANSLATE_NOOP("Field", "Most shear"),
                 .meaning = "100 times the tangent of the angle by which threads leave the right angle",
                 .verb = verb},
                strainLimit, s.shear...);
    }
};

template <>
struct Description<Fabric> {
    static constexpr const char* word = "fabric";
    static constexpr KindNames names{120, QT_TRANSLATE_NOOP("ElementText", "Fabric"),
                                     QT_TRANSLATE_NOOP("ElementText", "Fabrics"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 fabrics"), "fabric"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add fabric %1");
    /// It matters through the patches that are made of it.
    static SolveCost comes(const Fabric&) { return SolveCost::Nothing; }

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field(nameField, Text{}, s.name...);
        v.field({.key = "poisson",
                 .label = QT_TRANSLATE_NOOP("Field", "Poisson"),
                 .meaning = "transverse contraction; negative allows local scaling",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the Poisson parameter of %1"),
                 .cost = SolveCost::Retarget},
                Number{-0.5, 0.5, Unit::None, {.step = 0.05, .decimals = 3}}, s.poisson...);
        v.field({.key = "stiffness",
                 .label = QT_TRANSLATE_NOOP("Field", "Stiffness"),
                 .meaning = "relative to the other fabrics: of two that are sewn together the softer one stretches "
                            "more",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the stiffness of %1"),
                 .cost = SolveCost::Refactor},
                Number{1e-3, 1e3, Unit::None, {.step = 0.1, .decimals = 3}}, s.stiffness...);
        v.field(
            {.key = "bending_length",
             .label = QT_TRANSLATE_NOOP("Field", "Bending length"),
             .meaning = "sets the size of folds; below 0.35 `edge_length` the mesh cannot resolve it (a warning)",
             .verb = QT_TRANSLATE_NOOP("Message", "Change the bending length of %1"),
             .cost = SolveCost::Refactor},
            Number{0, 1e7, Unit::Millimetres}, s.bendingLength...);
        v.field({.key = "color",
                 .label = QT_TRANSLATE_NOOP("Field", "Colour"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the colour of %1")},
                Color{}, s.color...);
        v.group({.key = "look", .label = QT_TRANSLATE_NOOP("Field", "Look")}, s.look...);
        v.group({.key = "limits",
                 .label = QT_TRANSLATE_NOOP("Field", "Strain limits"),
                 .meaning = "how far it may be strained; a map of strain shows what is beyond"},
                s.limits...);
        v.group(cuttingField, s.cutting...);
        v.field(noteField, Text{}, s.note...);
    }
};

} // namespace bolster
