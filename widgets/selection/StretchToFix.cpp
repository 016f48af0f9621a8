#include "StretchToFix.h"

#include "ArcLength.h"
#include "Selection.h"

#include <algorithm>
#include <cmath>

namespace bolster {

Stretch outlineEdgeAt(ElementId patch, const BSpline2& outline, double parameter)
{
    const std::vector<double> corners = outline.corners();
    if (corners.empty())
        return {patch, outline.domainStart(), outline.domainStart()};
    const double t = outline.wrapped(parameter);
    const auto next = std::upper_bound(corners.begin(), corners.end(), t);
    const double from = next == corners.begin() ? corners.back() : *(next - 1);
    return {patch, from, next == corners.end() ? corners.front() : *next};
}

bool isOutlineEdge(const Design& design, const Stretch& stretch)
{
    const Patch* patch = design.find<Patch>(stretch.patch);
    if (!patch || patch->outline.empty())
        return false;
    const double slack = 1e-9 * patch->outline.period();
    const Stretch edge = outlineEdgeAt(stretch.patch, patch->outline, stretch.from + slack);
    return std::abs(edge.from - stretch.from) <= slack && std::abs(edge.to - stretch.to) <= slack;
}

bool stretchContains(const Stretch& stretch, const BSpline2& outline, double parameter)
{
    const double end = unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd());
    double t = outline.wrapped(parameter);
    while (t < stretch.from)
        t += outline.period();
    return t <= end;
}

std::optional<Stretch> stretchThroughPoints(const Design& design, const Selection& selection, ElementId patch)
{
    const Patch* found = design.find<Patch>(patch);
    if (!found || found->outline.empty())
        return std::nullopt;
    const BSpline2& outline = found->outline;
    std::set<double> places;
    for (const auto& [id, point] : selection.points())
        if (id == patch && point >= 0 && point < outline.pointCount())
            places.insert(outline.wrapped(outline.parameterOfPoint(point)));
    if (places.size() < 2)
        return std::nullopt;
    const ArcLength2 length(outline);
    std::vector<double> t(places.begin(), places.end());
    t.push_back(t.front() + outline.period());
    std::size_t longest = 0;
    for (std::size_t k = 0; k + 1 < t.size(); ++k)
        if (length.between(t[k], t[k + 1]) > length.between(t[longest], t[longest + 1]) + 1e-6)
            longest = k;
    return Stretch{patch, outline.wrapped(t[longest + 1]), t[longest]};
}

std::optional<Stretch> stretchToFix(const Design& design, const Selection& selection)
{
    if (selection.points().empty() && !selection.edges().empty())
        return selection.edges().size() == 1 ? std::optional(selection.edges().front().stretch) : std::nullopt;
    std::vector<Stretch> found;
    for (const ElementId id : selection.elements()) {
        if (const auto stretch = stretchThroughPoints(design, selection, id))
            found.push_back(*stretch);
        else if (const Seam* seam = design.find<Seam>(id))
            found.push_back(seam->a);
        else if (const FixationSeam* fixation = design.find<FixationSeam>(id))
            found.push_back(fixation->stretch);
    }
    return found.size() == 1 ? std::optional(found.front()) : std::nullopt;
}

} // namespace bolster
