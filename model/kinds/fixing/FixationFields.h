// What is said of each field of fixation curves and fixation seams.
#pragma once

#include "FixationCurve.h"
#include "FixationSeam.h"
#include "OrientationFields.h"
#include "TrimFields.h"
#include "TwinFields.h"

namespace bolster {

template <>
struct Description<FixationCurve> {
    static constexpr const char* word = "fixation_curve";
    static constexpr KindNames names{30, QT_TRANSLATE_NOOP("ElementText", "Fixation curve"),
                                     QT_TRANSLATE_NOOP("ElementText", "Fixation curves"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 fixation curves"), "fixation-curve"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add fixation curve %1");
    /// It matters through the fixation seams that use it.
    static SolveCost comes(const FixationCurve&) { return SolveCost::Nothing; }

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field(nameField, Text{}, s.name...);
        v.group(twinField, s.twin...);
        v.field({.key = "curve",
                 .label = QT_TRANSLATE_NOOP("Field", "Curve"),
                 .meaning = "open or closed, in space",
                 .cost = SolveCost::Retarget,
                 .presence = Presence::Required},
                Curve{}, s.curve...);
        v.field(noteField, Text{}, s.note...);
    }
};

template <>
struct Description<FixationSeam> {
    static constexpr const char* word = "fixation_seam";
    static constexpr KindNames names{40, QT_TRANSLATE_NOOP("ElementText", "Fixation"),
                                     QT_TRANSLATE_NOOP("ElementText", "Fixations"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 fixations"), "fixation-seam"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Add a fixation seam");
    static SolveCost comes(const FixationSeam&) { return SolveCost::Resew; }

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.part({.cost = SolveCost::Resew}, s.stretch...);
        v.field({.key = "curve",
                 .label = QT_TRANSLATE_NOOP("Field", "Curve"),
                 .meaning = "needed unless there is a `normal` or `tangent`",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the curve of %1"),
                 .cost = SolveCost::Resew,
                 .counts = ((s.hasCurve() || s.orientation.empty()) || ...),
                 .unless = {"normal", "tangent"}},
                Refers<FixationCurve>{}, s.curve...);
        v.field({.key = "curve_from",
                 .label = QT_TRANSLATE_NOOP("Field", "On the curve"),
                 .meaning = "a part of the curve, by the rules for stretches; both or none",
                 .cost = SolveCost::Resew},
                CurveRange{"curve_to"}, s.curveRange...);
        v.field({.key = "reversed",
                 .label = QT_TRANSLATE_NOOP("Field", "Curve runs backwards"),
                 .meaning = "the curve is walked backwards",
                 .verb = QT_TRANSLATE_NOOP("Message", "Reverse %1"),
                 .cost = SolveCost::Resew},
                Flag{}, s.reversed...);
        describeMatch(v, SolveCost::Resew, s.match...);
        v.part({}, s.orientation...);
        v.group(trimField, s.trim...);
        v.field(noteField, Text{}, s.note...);
    }
};

} // namespace bolster
