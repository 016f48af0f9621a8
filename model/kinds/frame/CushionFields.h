// What is said of each field of a cushion.
#pragma once

#include "Cushion.h"
#include "Field.h"

namespace bolster {

struct Frame;
struct Patch;

template <>
struct Description<Cushion> {
    static constexpr const char* word = "cushion";
    static constexpr KindNames names{90, QT_TRANSLATE_NOOP("ElementText", "Cushion"),
                                     QT_TRANSLATE_NOOP("ElementText", "Cushions"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 cushions"), "cushion"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add cushion %1");
    static SolveCost comes(const Cushion&) { return SolveCost::Retarget; }

    static constexpr const char* distances[] = {"city-block", "euclidean"};
    static constexpr const char* distanceLabels[] = {QT_TRANSLATE_NOOP("Field", "Press harder"),
                                                     QT_TRANSLATE_NOOP("Field", "Press like straight ones")};

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        const SolveCost cost = (s.enabled || ...) ? SolveCost::Retarget : SolveCost::Nothing;
        v.field(nameField, Text{}, s.name...);
        v.field({.key = "frame",
                 .label = QT_TRANSLATE_NOOP("Field", "Frame"),
                 .tip = QT_TRANSLATE_NOOP("Field", "The frame that is padded"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the frame of %1"),
                 .cost = cost,
                 .presence = Presence::Required},
                Refers<Frame>{}, s.frame...);
        v.field({.key = "parts",
                 .label = QT_TRANSLATE_NOOP("Field", "Padded parts"),
                 .meaning = "a list of names of parts (groups) of the frame's file; without it they are guessed",
                 .cost = cost},
                Names{}, s.parts...);
        v.field({.key = "patches",
                 .label = QT_TRANSLATE_NOOP("Field", "Pushes"),
                 .meaning =
                     "a list of ids of patches: it pushes what they are sewn to, and nothing else; without it "
                     "everything",
                 .tip = QT_TRANSLATE_NOOP("Field", "Which cover the padding presses outwards"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change what %1 pushes"),
                 .cost = cost},
                Refers<Patch>{Need::Listed}, s.patches...);
        v.field({.key = "voxel_mm",
                 .label = QT_TRANSLATE_NOOP("Field", "Smallest detail"),
                 .meaning = "edge of the voxels",
                 .tip = QT_TRANSLATE_NOOP(
                     "Field", "How finely the frame is looked at: what is thinner may stay without padding"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the smallest detail of %1"),
                 .cost = cost},
                Number{0.5, 100, Unit::Millimetres}, s.voxel...);
        v.field({.key = "dilation_mm",
                 .label = QT_TRANSLATE_NOOP("Field", "Padding"),
                 .meaning = "how thick the padding is, rounded to whole voxels",
                 .tip = QT_TRANSLATE_NOOP("Field", "How thick the padding around the frame is"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the padding of %1"),
                 .cost = cost},
                Number{0, 1000, Unit::Millimetres, {.step = 5, .sliderMost = 100}}, s.dilation...);
        v.field({.key = "strength",
                 .label = QT_TRANSLATE_NOOP("Field", "Strength"),
                 .meaning = "scales the force; from about 2 on the cover gives no more",
                 .tip = QT_TRANSLATE_NOOP(
                     "Field", "How hard the padding presses the cover outwards; from about 2 on it gives no more"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the strength of %1"),
                 .cost = cost},
                Number{0, 10, Unit::None, {.step = 0.1, .decimals = 3, .sliderMost = 2}}, s.strength...);
        v.field({.key = "distance",
                 .label = QT_TRANSLATE_NOOP("Field", "Slanted faces"),
                 .meaning = "how depth is measured: along the axes of the frame's file, or straight",
                 .tip = QT_TRANSLATE_NOOP(
                     "Field",
                     "How padding presses that is aslant to width, depth and height: harder fills the cover more"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the slanted faces of %1"),
                 .cost = cost},
                Words{distances, distanceLabels}, s.distance...);
        v.field({.key = "enabled",
                 .label = QT_TRANSLATE_NOOP("Field", "Pushes the cover"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Switch %1"),
                 .cost = cost},
                Flag{}, s.enabled...);
        v.field(noteField, Text{}, s.note...);
    }
};

} // namespace bolster
