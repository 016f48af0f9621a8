// What is said of each field of a trim, and of the trim of an outline. The solver knows nothing of them.
#pragma once

#include "OutlineTrim.h"
#include "StretchFields.h"

namespace bolster {

struct Fabric;

template <>
struct Description<SeamTrim> {
    static constexpr const char* section = "see [trims](#trims)";
    static constexpr const char* stitches[] = {"none", "single", "twin"};
    static constexpr const char* stitchLabels[] = {QT_TRANSLATE_NOOP("Field", "None"),
                                                   QT_TRANSLATE_NOOP("Field", "Single row"),
                                                   QT_TRANSLATE_NOOP("Field", "Twin rows")};
    static constexpr const char* stitching = QT_TRANSLATE_NOOP("Message", "Change the stitching of %1");
    static constexpr const char* piping = QT_TRANSLATE_NOOP("Message", "Change the piping of %1");

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field(
            {.key = "stitch",
             .label = QT_TRANSLATE_NOOP("Field", "Stitches"),
             .meaning = "one row, of a seam on its first side, or a row on both sides, along an outline two inside",
             .verb = stitching,
             .alone = QT_TRANSLATE_NOOP("Field", "Stitching")},
            Words{stitches, stitchLabels}, s.stitch...);
        v.field({.key = "thread",
                 .label = QT_TRANSLATE_NOOP("Field", "Thread"),
                 .meaning = "its colour",
                 .verb = stitching,
                 .alone = QT_TRANSLATE_NOOP("Field", "Thread colour")},
                Color{}, s.thread...);
        v.field(
            {.key = "stitch_length_mm", .label = QT_TRANSLATE_NOOP("Field", "Stitch length"), .verb = stitching},
            Number{0.5, 100, Unit::Millimetres, {.step = 0.5}}, s.stitchLength...);
        v.field({.key = "stitch_distance_mm",
                 .label = QT_TRANSLATE_NOOP("Field", "Distance from the seam"),
                 .verb = stitching,
                 .alone = QT_TRANSLATE_NOOP("Field", "Stitch distance")},
                Number{0, 100, Unit::Millimetres, {.step = 0.5}}, s.stitchDistance...);
        v.field({.key = "thread_width_mm", .label = QT_TRANSLATE_NOOP("Field", "Thread width"), .verb = stitching},
                Number{0.05, 10, Unit::Millimetres, {.step = 0.1}}, s.threadWidth...);
        v.field({.key = "piping_radius_mm",
                 .label = QT_TRANSLATE_NOOP("Field", "Radius (0: none)"),
                 .meaning = "of the piping; 0: none",
                 .verb = piping,
                 .alone = QT_TRANSLATE_NOOP("Field", "Piping radius")},
                Number{0, 50, Unit::Millimetres, {.step = 0.5}}, s.pipingRadius...);
        v.field({.key = "piping_fabric",
                 .label = QT_TRANSLATE_NOOP("Field", "Fabric"),
                 .meaning = "of the piping; without it that of the patch",
                 .verb = piping,
                 .alone = QT_TRANSLATE_NOOP("Field", "Piping fabric")},
                Refers<Fabric>{Need::Seen}, s.pipingFabric...);
        v.field(
            {.key = "allowance_mm",
             .label = QT_TRANSLATE_NOOP("Field", "Bulge of the allowance"),
             .meaning = "width of the bulge that the allowance of a seam between patches makes beside it; 0: none",
             .verb = QT_TRANSLATE_NOOP("Message", "Change the seam allowance of %1")},
            Number{0, 100, Unit::Millimetres}, s.allowance...);
        v.field({.key = "valley",
                 .label = QT_TRANSLATE_NOOP("Field", "The cover dips into the seam"),
                 .meaning = "the cover dips into a seam between patches",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the valley of %1"),
                 .alone = QT_TRANSLATE_NOOP("Field", "Valley")},
                Flag{}, s.valley...);
    }
};

inline constexpr Field trimField{.key = "trim", .label = QT_TRANSLATE_NOOP("Field", "Trim")};

template <>
struct Description<OutlineTrim> {
    static constexpr const char* word = "outline_trim";
    static constexpr KindNames names{70, QT_TRANSLATE_NOOP("ElementText", "Trimmed edge"),
                                     QT_TRANSLATE_NOOP("ElementText", "Trimmed edges"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 trimmed edges"), "outline-trim"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add a trim");
    static SolveCost comes(const OutlineTrim&) { return SolveCost::Nothing; }

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.part({}, s.stretch...);
        v.group(trimField, s.trim...);
        v.field(noteField, Text{}, s.note...);
    }
};

} // namespace bolster
