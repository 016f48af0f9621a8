// What is said of each field of seam allowances and their corners.
#pragma once

#include "CutCorner.h"
#include "EdgeAllowance.h"
#include "StretchFields.h"

namespace bolster {

inline constexpr Number allowanceWidth{0, 200, Unit::Millimetres, {.step = 1, .decimals = 2}};
inline constexpr const char* cornerJoinKeys[] = {"mitred", "square", "rounded", "folded", "stepped"};
inline constexpr const char* cornerJoinLabels[] = {
    QT_TRANSLATE_NOOP("Field", "Mitred \u2013 to a point"), QT_TRANSLATE_NOOP("Field", "Square \u2013 cut off"),
    QT_TRANSLATE_NOOP("Field", "Rounded"), QT_TRANSLATE_NOOP("Field", "Folded \u2013 lies under the piece"),
    QT_TRANSLATE_NOOP("Field", "Stepped")};

template <>
struct Description<CutAllowance> {
    static constexpr const char* section = "see [cutting](#cutting)";
    static constexpr const char* verb = QT_TRANSLATE_NOOP("Message", "Change the seam allowance of %1");

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "width_mm",
                 .label = QT_TRANSLATE_NOOP("Field", "Allowance"),
                 .meaning = "from the sewing line to the cut line",
                 .tip = QT_TRANSLATE_NOOP("Field", "From the sewing line to the line where the fabric is cut."),
                 .verb = verb,
                 .alone = QT_TRANSLATE_NOOP("Field", "Seam allowance")},
                allowanceWidth, s.width...);
        v.field({.key = "corner",
                 .label = QT_TRANSLATE_NOOP("Field", "Corners"),
                 .meaning = "how the cut lines of two edges are joined",
                 .verb = verb,
                 .alone = QT_TRANSLATE_NOOP("Field", "Corners of the cut line")},
                Words{cornerJoinKeys, cornerJoinLabels}, s.corner...);
    }
};

inline constexpr Field allowanceField{.key = "allowance",
                                      .label = QT_TRANSLATE_NOOP("Field", "Seam allowance"),
                                      .without = QT_TRANSLATE_NOOP("Field", "as the design's")};

template <>
struct Description<OutlinePlace> {
    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "patch", .label = QT_TRANSLATE_NOOP("Field", "Patch"), .presence = Presence::Required},
                Refers<Patch>{}, s.patch...);
        v.field({.key = "at",
                 .label = QT_TRANSLATE_NOOP("Field", "Lies at"),
                 .meaning = "parameter of the outline",
                 .presence = Presence::Required},
                Number{.checked = false}, s.at...);
    }
};

template <>
struct Description<EdgeAllowance> {
    static constexpr const char* word = "edge_allowance";
    static constexpr KindNames names{72, QT_TRANSLATE_NOOP("ElementText", "Allowance of an edge"),
                                     QT_TRANSLATE_NOOP("ElementText", "Allowances of edges"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 allowances of edges"), "edge-allowance"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Give an edge its own seam allowance");
    static SolveCost comes(const EdgeAllowance&) { return SolveCost::Nothing; }

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.part({}, s.stretch...);
        v.field({.key = "width_mm",
                 .label = QT_TRANSLATE_NOOP("Field", "Allowance"),
                 .meaning = "from the sewing line to the cut line; 0: cut on the sewing line",
                 .tip = QT_TRANSLATE_NOOP("Field", "From the sewing line to the line where the fabric is cut."),
                 .verb = QT_TRANSLATE_NOOP("Message", "Change the seam allowance of %1")},
                allowanceWidth, s.width...);
        v.field(noteField, Text{}, s.note...);
    }
};

template <>
struct Description<CutCorner> {
    static constexpr const char* word = "cut_corner";
    static constexpr KindNames names{74, QT_TRANSLATE_NOOP("ElementText", "Corner of the cut line"),
                                     QT_TRANSLATE_NOOP("ElementText", "Corners of the cut line"),
                                     QT_TRANSLATE_NOOP("ElementText", "%1 corners of the cut line"), "cut-corner"};
    static constexpr const char* added = QT_TRANSLATE_NOOP("Message", "Change a corner of the cut line");
    static SolveCost comes(const CutCorner&) { return SolveCost::Nothing; }

    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.part({}, s.place...);
        v.field({.key = "join",
                 .label = QT_TRANSLATE_NOOP("Field", "Corner"),
                 .meaning = "how the cut lines of its two edges are joined",
                 .verb = QT_TRANSLATE_NOOP("Message", "Change a corner of the cut line"),
                 .presence = Presence::Always},
                Words{cornerJoinKeys, cornerJoinLabels}, s.join...);
        v.field(noteField, Text{}, s.note...);
    }
};

} // namespace bolster
