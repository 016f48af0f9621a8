// What lies on the patches of a design, patch by patch: whoever asks for each of them should not walk through the
// whole design every time.
#pragma once

#include "Design.h"

#include <map>
#include <optional>
#include <vector>

namespace bolster {

/// Where the mouth of a dart ends.
struct MouthEnd {
    double at = 0;     ///< parameter of the outline
    bool ahead = true; ///< its leg begins there, else it ends there
};

/// Whose legs are sewn to each other.
struct DartMark {
    ElementId seam{};
    double from = 0, to = 0; ///< parameters of the outline: where the mouth ends
    Vec2 tip = Vec2::Zero(); ///< outline coordinates, mm
};

/// Of one patch. Widths are within the limits of the fields, whatever the design says.
struct CutMarks {
    std::vector<EdgeAllowance> edges;
    std::vector<CutCorner> corners;
    std::vector<std::pair<ElementId, const DrillHole*>> holes; ///< of the design
    std::vector<std::pair<ElementId, const PatchCurve*>> lines;
    std::vector<MouthEnd> mouthEnds;
    std::vector<DartMark> darts;

    /// Of the edge at a parameter of the patch's outline, mm; `usual` where it has none of its own.
    double widthAt(const BSpline2& outline, double t, double usual) const;
};

using MarksByPatch = std::map<ElementId, CutMarks>;

MarksByPatch cutMarks(const Design& design);

/// A width within the limits of the fields, mm.
double possibleWidth(double width);

/// The width at a place of an outline, mm: that of the edge there, or the patch's, as allowanceOf() has it.
double allowanceAt(const Design& design, const MarksByPatch& marks, const OutlinePlace& place,
                   std::optional<double> otherwise);

} // namespace bolster
