// What is said of each field of curves that are drawn in a patch: handle curves and fancy seams.
#pragma once

#include "FancySeam.h"
#include "HandleCurve.h"
#include "InternalLine.h"
#include "OrientationFields.h"
#include "TrimFields.h"
#include "TwinFields.h"

namespace bolster {

template <>
struct Description<PatchCurve> {
    static constexpr const char* uses[] = {"drawn", "cut", "ignored"};
    static constexpr const char* useLabels[] = {QT_TRANSLATE_NOOP("Field", "Drawn"),
                                                QT_TRANSLATE_NOOP("Field", "Cut"),
                                                QT_TRANSLATE_NOOP("Field", "Left out")};

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field(nameField, Text{}, s.name...);
        v.field({.key = "patch",
                 .label = QT_TRANSLATE_NOOP("Field", "Patch"),
                 .cost = SolveCost::Rebuild,
                 .presence = Presence::Required},
                Refers<Patch>{}, s.patch...);
        v.field({.key = "use",
                 .label = QT_TRANSLATE_NOOP("Field", "On the cutting table"),
                 .meaning = "what becomes of it when its piece is cut",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change how %1 is cut")},
                Words{uses, useLabels}, s.use...);
        v.group(twinField, s.twin...);
        v.field({.key = "curve",
                 .label = QT_TRANSLATE_NOOP("Field", "Curve"),
                 .meaning = "open or closed, in outline coordinates",
                 .cost = SolveCost::Warp,
                 .presence = Presence::Required},
                Curve{}, s.curve...);
    }
};

template <>
struct Description<HandleCurve> {
    static constexpr const char* word = "handle_curve";
    static constexpr KindNames names{50, QT_TRANSLATE_NOOP("ElementText", "Handle curve"),
                                     QT_TRANSLATE_NOOP("ElementText", "Handle curves"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 handle curves"), "handle-curve"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add handle curve %1");
    /// A new one begins where the surface is, so nothing is torn.
    static SolveCost comes(const HandleCurve&) { return SolveCost::Rebuild; }

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.part({}, asBase<PatchCurve>(s)...);
        v.field({.key = "target",
                 .label = QT_TRANSLATE_NOOP("Field", "Curve in space"),
                 .meaning =
                     "closed when `curve` is: the cover passes through it; needed unless there is a `normal` or "
                     "`tangent`",
                 .cost = SolveCost::Retarget,
                 .counts = ((s.hasTarget() || s.orientation.empty()) || ...),
                 .unless = {"normal", "tangent"}},
                Curve{}, s.target...);
        describeMatch(v, SolveCost::Rebuild, s.match...);
        v.part({}, s.orientation...);
        v.field(noteField, Text{}, s.note...);
    }
};

template <>
struct Description<FancySeam> {
    static constexpr const char* word = "fancy_seam";
    static constexpr KindNames names{60, QT_TRANSLATE_NOOP("ElementText", "Fancy seam"),
                                     QT_TRANSLATE_NOOP("ElementText", "Fancy seams"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 fancy seams"), "fancy-seam"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add fancy seam %1");
    static SolveCost comes(const FancySeam&) { return SolveCost::Rebuild; }

    static constexpr const char* profiles[] = {"round", "sharp", "welt"};
    static constexpr const char* profileLabels[] = {QT_TRANSLATE_NOOP("Field", "Round \u2013 a soft groove"),
                                                    QT_TRANSLATE_NOOP("Field", "Sharp \u2013 a crease"),
                                                    QT_TRANSLATE_NOOP("Field", "Welt \u2013 between creases")};

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.part({}, asBase<PatchCurve>(s)...);
        v.field({.key = "width",
                 .label = QT_TRANSLATE_NOOP("Field", "Width"),
                 .meaning = "in the pattern, at least a sixth of the edge length",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the width of %1"),
                 .cost = SolveCost::Warp},
                Number{0.1, 1000, Unit::Millimetres, {.sliderLeast = 1, .sliderMost = 60}}, s.width...);
        v.field({.key = "depth",
                 .label = QT_TRANSLATE_NOOP("Field", "Depth"),
                 .meaning = "how far the middle lies below the cover; negative above it",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the depth of %1"),
                 .cost = SolveCost::Republish},
                Number{-1000, 1000, Unit::Millimetres, {.step = 0.5, .sliderLeast = -20, .sliderMost = 20}},
                s.depth...);
        v.field({.key = "profile",
                 .label = QT_TRANSLATE_NOOP("Field", "Profile"),
                 .meaning = "the cross section: a groove, a crease in the middle, creases on both sides",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the profile of %1"),
                 .cost = SolveCost::Republish},
                Words{profiles, profileLabels}, s.profile...);
        v.group(trimField, s.trim...);
        v.field(noteField, Text{}, s.note...);
    }
};

template <>
struct Description<InternalLine> {
    static constexpr const char* word = "internal_line";
    static constexpr KindNames names{65, QT_TRANSLATE_NOOP("ElementText", "Internal line"),
                                     QT_TRANSLATE_NOOP("ElementText", "Internal lines"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 internal lines"), "internal-line"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add internal line %1");
    static SolveCost comes(const InternalLine&) { return SolveCost::Nothing; }
    static constexpr bool shapesNothing = true;

    static constexpr const char* purposes[] = {"guide", "top_stitch", "tie_down", "fold"};
    static constexpr const char* purposeLabels[] = {
        QT_TRANSLATE_NOOP("Field", "Guide"), QT_TRANSLATE_NOOP("Field", "Top stitching"),
        QT_TRANSLATE_NOOP("Field", "Tie-down strip"), QT_TRANSLATE_NOOP("Field", "Fold")};

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.part({}, asBase<PatchCurve>(s)...);
        v.field({.key = "purpose",
                 .label = QT_TRANSLATE_NOOP("Field", "Purpose"),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the purpose of %1")},
                Words{purposes, purposeLabels}, s.purpose...);
        v.field(noteField, Text{}, s.note...);
    }
};

} // namespace bolster
