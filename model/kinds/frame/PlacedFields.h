// What is said of each field of what places a file, or a shape: frames, foam and scans.
#pragma once

#include "Field.h"
#include "Foam.h"
#include "Frame.h"
#include "Scan.h"

namespace bolster {

struct Cushion;

inline constexpr Number placedScale{
    0, 1e7, Unit::MillimetresPerUnit, {.step = 0.1, .decimals = 6, .least = 1e-6, .most = 1e6}, false};

template <>
struct Description<Placement> {
    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "scale",
                 .label = QT_TRANSLATE_NOOP("Field", "Scale"),
                 .meaning = "mm per unit of the file, > 0",
                 .verb = QT_TRANSLATE_NOOP("Message", "Scale %1")},
                placedScale, s.scale...);
        v.field({.key = "position",
                 .label = QT_TRANSLATE_NOOP("Field", "Position"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Move %1")},
                Coordinates{.box = {.decimals = 3}}, s.position...);
        v.field({.key = "rotation",
                 .label = QT_TRANSLATE_NOOP("Field", "Rotation"),
                 .meaning = "quaternion [w, x, y, z] of length 1 (normalised when within 0.001 of it)",
                 .verb = QT_TRANSLATE_NOOP("Message", "Turn %1")},
                Turn{}, s.rotation...);
    }
};

template <>
struct Description<FrameMaterial> {
    static constexpr const char* kinds[] = {"plain", "wood", "metal", "plastic", "foam"};
    static constexpr const char* kindLabels[] = {
        QT_TRANSLATE_NOOP("Field", "Plain"), QT_TRANSLATE_NOOP("Field", "Wood"),
        QT_TRANSLATE_NOOP("Field", "Metal"), QT_TRANSLATE_NOOP("Field", "Plastic"),
        QT_TRANSLATE_NOOP("Field", "Foam")};

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "kind",
                 .label = QT_TRANSLATE_NOOP("Field", "Material"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the material of %1")},
                Words{kinds, kindLabels}, s.kind...);
        v.field({.key = "color",
                 .label = QT_TRANSLATE_NOOP("Field", "Colour"),
                 .meaning = "the usual one of the kind without it",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the colour of %1")},
                Color{.mayBeEmpty = true}, s.color...);
    }
};

template <>
struct Description<Frame> {
    static constexpr const char* word = "frame";
    static constexpr KindNames names{80, QT_TRANSLATE_NOOP("ElementText", "Frame"),
                                     QT_TRANSLATE_NOOP("ElementText", "Frames"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 frames"), "frame"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add frame %1");
    static SolveCost comes(const Frame& frame) { return frame.contact ? SolveCost::Retarget : SolveCost::Nothing; }

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field(nameField, Text{}, s.name...);
        v.field(
            {.key = "file",
             .label = QT_TRANSLATE_NOOP("Field", "File"),
             .meaning =
                 "of a format that frames are read from, relative to the design, with `/` between folders, never "
                 "outside the design's folder; a face has at most 10,000 corners",
             .presence = Presence::Required},
            FileName{}, s.file...);
        v.part({.cost = SolveCost::Retarget}, asBase<Placement>(s)...);
        v.field({.key = "contact",
                 .label = QT_TRANSLATE_NOOP("Field", "Keeps the cover outside"),
                 .meaning = "keeps each cover outside of the parts of the frame that belong to it (see cushion)",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the contact of %1"),
                 .cost = SolveCost::Retarget},
                Flag{}, s.contact...);
        v.field({.key = "contact_gap",
                 .label = QT_TRANSLATE_NOOP("Field", "Gap"),
                 .meaning = "that it keeps away then",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the gap of %1"),
                 .cost = (s.contact || ...) ? SolveCost::Retarget : SolveCost::Nothing},
                Number{0, 100, Unit::Millimetres}, s.contactGap...);
        v.group({.key = "material", .label = QT_TRANSLATE_NOOP("Field", "Material")}, s.material...);
        v.field({.key = "hidden_parts",
                 .label = QT_TRANSLATE_NOOP("Field", "Hidden parts"),
                 .meaning =
                     "a list of names of parts (groups) of the file that are left out as if they were not in "
                     "it; where a part consists of pieces that do not hang together, `\"Seat#2\"` is the second "
                     "largest piece of `\"Seat\"`",
                 .cost = SolveCost::Retarget},
                Names{}, s.hiddenParts...);
        v.field(noteField, Text{}, s.note...);
    }
};

template <>
struct Description<Foam> {
    static constexpr const char* word = "foam";
    static constexpr KindNames names{100, QT_TRANSLATE_NOOP("ElementText", "Foam"),
                                     QT_TRANSLATE_NOOP("ElementText", "Foam"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 pieces of foam"), "foam"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add foam %1");
    static SolveCost comes(const Foam&) { return SolveCost::Retarget; }

    static constexpr const char* shapes[] = {"box", "cylinder", "sphere", "mesh"};
    static constexpr const char* shapeLabels[] = {
        QT_TRANSLATE_NOOP("Field", "Box"), QT_TRANSLATE_NOOP("Field", "Cylinder"),
        QT_TRANSLATE_NOOP("Field", "Sphere"), QT_TRANSLATE_NOOP("Field", "Mesh")};

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        const bool fromFile = ((s.shape == Foam::Shape::Mesh) || ...);
        v.field(nameField, Text{}, s.name...);
        v.field({.key = "cushion",
                 .label = QT_TRANSLATE_NOOP("Field", "Cushion"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the cushion of %1"),
                 .cost = SolveCost::Retarget,
                 .presence = Presence::Required},
                Refers<Cushion>{}, s.cushion...);
        v.field({.key = "shape",
                 .label = QT_TRANSLATE_NOOP("Field", "Shape"),
                 .meaning = "a cylinder stands about its z axis",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the shape of %1"),
                 .cost = SolveCost::Retarget},
                Words{shapes, shapeLabels}, s.shape...);
        v.field({.key = "size",
                 .label = QT_TRANSLATE_NOOP("Field", "Size"),
                 .meaning = "of box, cylinder and sphere along their own axes",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the size of %1"),
                 .cost = SolveCost::Retarget,
                 .counts = !fromFile},
                Coordinates{1, 1e7, Unit::Millimetres, {.step = 5}}, s.size...);
        v.field({.key = "file",
                 .label = QT_TRANSLATE_NOOP("Field", "File"),
                 .meaning = "of a mesh, as with frames",
                 .cost = SolveCost::Retarget,
                 .counts = fromFile},
                FileName{}, s.file...);
        v.part({.cost = SolveCost::Retarget}, asBase<Placement>(s)...);
        v.field({.key = "dilation_mm",
                 .label = QT_TRANSLATE_NOOP("Field", "Padding"),
                 .meaning = "padding around it",
                 .tip = QT_TRANSLATE_NOOP("Field", "How thick the padding around this foam is"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the padding of %1"),
                 .cost = SolveCost::Retarget},
                Number{0, 1000, Unit::Millimetres, {.step = 5, .sliderMost = 100}}, s.dilation...);
        v.field({.key = "strength",
                 .label = QT_TRANSLATE_NOOP("Field", "Strength"),
                 .meaning =
                     "scales the force where it lies; where bodies overlap, that of the one with the larger id "
                     "counts",
                 .tip = QT_TRANSLATE_NOOP(
                     "Field", "How hard this foam presses the cover outwards; from about 2 on it gives no more"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the strength of %1"),
                 .cost = SolveCost::Retarget},
                Number{0, 10, Unit::None, {.step = 0.1, .decimals = 3, .sliderMost = 2}}, s.strength...);
        v.field({.key = "cut",
                 .label = QT_TRANSLATE_NOOP("Field", "Cut away"),
                 .meaning = "taken away, with its padding, from the frame and from all foam that is added",
                 .tip = QT_TRANSLATE_NOOP("Field", "Takes this shape out of the cushion instead of adding it"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Add or cut %1"),
                 .cost = SolveCost::Retarget},
                Flag{}, s.cut...);
        v.field(noteField, Text{}, s.note...);
    }
};

template <>
struct Description<ScanCut> {
    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "planes",
                 .meaning = "[x, y, z, d] each: the points with x p_x + y p_y + z p_z <= d, before `scale`",
                 .presence = Presence::Required},
                Planes{100}, s.halfSpaces...);
        v.field({.key = "keep", .meaning = "cuts away what lies outside instead"}, Flag{}, s.keep...);
    }
};

template <>
struct Description<Scan> {
    static constexpr const char* word = "scan";
    static constexpr KindNames names{110, QT_TRANSLATE_NOOP("ElementText", "Scan"),
                                     QT_TRANSLATE_NOOP("ElementText", "Scans"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 scans"), "scan"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add scan %1");
    static SolveCost comes(const Scan&) { return SolveCost::Retarget; }

    static constexpr const char* targets[] = {"plane", "point"};
    static constexpr const char* targetLabels[] = {QT_TRANSLATE_NOOP("Field", "Along the normal"),
                                                   QT_TRANSLATE_NOOP("Field", "To the point itself")};

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field(nameField, Text{}, s.name...);
        v.field({.key = "file",
                 .label = QT_TRANSLATE_NOOP("Field", "File"),
                 .meaning = "PLY, XYZ or PCD, by the rules for frames; points that are not finite are skipped",
                 .cost = SolveCost::Retarget,
                 .presence = Presence::Required},
                FileName{}, s.file...);
        v.part({.cost = SolveCost::Retarget}, asBase<Placement>(s)...);
        v.field({.key = "threshold_mm",
                 .label = QT_TRANSLATE_NOOP("Field", "Threshold"),
                 .meaning = "vertices further than this from every point are not pulled",
                 .tip = QT_TRANSLATE_NOOP("Field", "How near a point of the scan must be to pull at the cover. "
                                                   "What the scan has not seen stays as the pattern makes it."),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the threshold of %1"),
                 .cost = SolveCost::Retarget},
                Number{0.1, 1e4, Unit::Millimetres, {.step = 5, .decimals = 1}}, s.threshold...);
        v.field({.key = "strength",
                 .label = QT_TRANSLATE_NOOP("Field", "Strength"),
                 .meaning = "of the pull; more follows finer detail and more of the noise",
                 .tip = QT_TRANSLATE_NOOP("Field", "How firmly the scan pulls at the cover, against the pattern: "
                                                   "more follows finer detail, and more of the noise."),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the strength of %1"),
                 .cost = SolveCost::Retarget},
                Number{0, 100, Unit::None, {.step = 0.25, .sliderMost = 5}}, s.strength...);
        // One that is switched off is measured all the same.
        v.field({.key = "enabled",
                 .label = QT_TRANSLATE_NOOP("Field", "Fit the cover to it"),
                 .meaning = "`false`: the cover is only measured against it",
                 .tip = QT_TRANSLATE_NOOP("Field", "The cover is pulled to the scan. Without that it is only "
                                                   "measured. Align the scan first."),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change whether the cover fits %1"),
                 .cost = SolveCost::Retarget},
                Flag{}, s.enabled...);
        v.field(
            {.key = "target",
             .label = QT_TRANSLATE_NOOP("Field", "Pull"),
             .meaning = "vertices are pulled along their normals and slide otherwise, or to the points themselves",
             .tip =
                 QT_TRANSLATE_NOOP("Field", "To its surface: the cover may slide along it. To its points: it may "
                                            "not, which suits scans with few points."),
             .verb = QT_TRANSLATE_NOOP("Message", "Change how %1 pulls"),
             .cost = SolveCost::Retarget},
            Words{targets, targetLabels}, s.target...);
        v.list({.key = "cuts",
                .label = QT_TRANSLATE_NOOP("Field", "Cuts"),
                .meaning = "regions whose points do not count: floor, walls. At most 1000",
                .cost = SolveCost::Retarget},
               Entries{.wrongList = QT_TRANSLATE_NOOP("Message", "must be a list of at most %1 cuts in braces"),
                       .wrongEntry = QT_TRANSLATE_NOOP("Message", "must be a cut in braces, with planes"),
                       .most = 1000},
               s.cuts...);
        v.field(noteField, Text{}, s.note...);
    }
};

} // namespace bolster
