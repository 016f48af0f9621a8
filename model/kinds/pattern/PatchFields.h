// What is said of each field of a patch.
#pragma once

#include "Field.h"
#include "Patch.h"
#include "PieceCuttingFields.h"
#include "TwinFields.h"

namespace bolster {

struct Fabric;

template <>
struct Description<Patch> {
    static constexpr const char* word = "patch";
    static constexpr KindNames names{10, QT_TRANSLATE_NOOP("ElementText", "Patch"),
                                     QT_TRANSLATE_NOOP("ElementText", "Patches"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 patches"), "patch"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add patch %1");
    static SolveCost comes(const Patch&) { return SolveCost::Resew; }

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field(nameField, Text{}, s.name...);
        v.field({.key = "fabric",
                 .label = QT_TRANSLATE_NOOP("Field", "Fabric"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the fabric of %1"),
                 .cost = SolveCost::Rebuild,
                 .presence = Presence::Required},
                Refers<Fabric>{}, s.fabric...);
        v.field({.key = "position",
                 .label = QT_TRANSLATE_NOOP("Field", "Position"),
                 .meaning = "of the outline's origin in the layout",
                 .verb = QT_TRANSLATE_NOOP("Message", "Move %1 in the layout")},
                Coordinates{.box = {.decimals = 3}}, s.position...);
        v.field({.key = "rotation",
                 .label = QT_TRANSLATE_NOOP("Field", "Rotation"),
                 .meaning = "in the layout, counter-clockwise",
                 .verb = QT_TRANSLATE_NOOP("Message", "Turn %1 in the layout")},
                Number{-1e7, 1e7, Unit::Degrees, {.step = 5, .decimals = 3, .least = -360, .most = 360}},
                s.rotation...);
        v.field({.key = "grain",
                 .label = QT_TRANSLATE_NOOP("Field", "Grain"),
                 .meaning = "direction of the warp in the outline's coordinates, counter-clockwise",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the grain of %1")},
                Number{-1e7, 1e7, Unit::Degrees, {.step = 5, .decimals = 3, .least = -360, .most = 360}},
                s.grain...);
        v.field(
            {.key = "pressure",
             .label = QT_TRANSLATE_NOOP("Field", "Pressure"),
             .meaning = "from inside; 1 is a membrane force per D in units of the stretch stiffness, D the square "
                        "root of twice the rest area of all patches that are sewn together",
             .tip = QT_TRANSLATE_NOOP("Field", "A filling that presses from inside. 0.05 to 0.3 fills a cushion; "
                                               "at 1 most fabrics are stretched too far."),
             .verb = QT_TRANSLATE_NOOP("Message", "Change the pressure of %1"),
             .cost = SolveCost::Retarget},
            Number{-1000, 1000, Unit::None, {.step = 0.05, .decimals = 4, .sliderMost = 1}}, s.pressure...);
        // The outward side sits in the order of the triangles, so it needs a new mesh.
        v.field({.key = "wrong_side_out",
                 .label = QT_TRANSLATE_NOOP("Field", "Wrong side out"),
                 .meaning = "worn with -z of the pattern plane outside",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the right side of %1"),
                 .cost = SolveCost::Rebuild},
                Flag{}, s.wrongSideOut...);
        v.group(allowanceField, s.allowance...);
        v.group(cuttingField, s.cutting...);
        v.group(twinField, s.twin...);
        v.field({.key = "outline",
                 .label = QT_TRANSLATE_NOOP("Field", "Outline"),
                 .meaning = "a closed curve that encloses an area and neither crosses nor touches itself",
                 .cost = SolveCost::Warp,
                 .presence = Presence::Required},
                Curve{.outline = true}, s.outline...);
        v.field(noteField, Text{}, s.note...);
    }
};

} // namespace bolster
