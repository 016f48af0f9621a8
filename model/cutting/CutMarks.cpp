#include "CutMarks.h"

#include "AllowanceFields.h"
#include "CutPattern.h"
#include "FoldedSeam.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

bool isOn(const Stretch& stretch, const BSpline2& outline, double t)
{
    const double period = outline.period();
    const double length =
        unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd()) - stretch.from;
    return t - stretch.from - period * std::floor((t - stretch.from) / period) < length;
}

} // namespace

double possibleWidth(double width)
{
    return std::isfinite(width) ? std::clamp(width, allowanceWidth.least, allowanceWidth.most) : 0;
}

double CutMarks::widthAt(const BSpline2& outline, double t, double usual) const
{
    for (const EdgeAllowance& edge : edges)
        if (isOn(edge.stretch, outline, t))
            return edge.width;
    return usual;
}

MarksByPatch cutMarks(const Design& design)
{
    MarksByPatch marks;
    for (const auto& [id, element] : design.elements()) {
        if (const auto* edge = std::get_if<EdgeAllowance>(element.get())) {
            if (!std::isfinite(edge->stretch.from) || !std::isfinite(edge->stretch.to))
                continue;
            marks[edge->stretch.patch].edges.push_back(*edge);
            marks[edge->stretch.patch].edges.back().width = possibleWidth(edge->width);
        } else if (const auto* corner = std::get_if<CutCorner>(element.get())) {
            if (std::isfinite(corner->place.at))
                marks[corner->place.patch].corners.push_back(*corner);
        } else if (const auto* hole = std::get_if<DrillHole>(element.get())) {
            marks[hole->place.patch].holes.emplace_back(id, hole);
        } else if (const auto* seam = std::get_if<Seam>(element.get())) {
            if (const std::optional<FoldedSides> dart = foldedSides(design, *seam)) {
                marks[dart->patch].mouthEnds.push_back({dart->first.from, true});
                marks[dart->patch].mouthEnds.push_back({dart->second.to, false});
                marks[dart->patch].darts.push_back({id, dart->first.from, dart->second.to, dart->tip});
            }
        } else if (const PatchCurve* line = patchCurve(*element)) {
            marks[line->patch].lines.emplace_back(id, line);
        }
    }
    return marks;
}

double allowanceAt(const Design& design, const MarksByPatch& marks, const OutlinePlace& place,
                   std::optional<double> otherwise)
{
    const Patch* patch = design.find<Patch>(place.patch);
    if (!patch || patch->outline.empty())
        return 0;
    const double usual = allowanceOf(design, *patch, otherwise).width;
    const auto there = marks.find(place.patch);
    return there == marks.end() ? usual : there->second.widthAt(patch->outline, place.at, usual);
}

} // namespace bolster
