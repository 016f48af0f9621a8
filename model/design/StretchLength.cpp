#include "StretchLength.h"

#include "ArcLength.h"

namespace bolster {

std::optional<std::pair<double, double>> stretchRange(const Stretch& stretch, const BSpline2& outline)
{
    if (outline.empty())
        return std::nullopt;
    const auto [low, high] = addressable(outline);
    if (!(stretch.from >= low && stretch.from <= high && stretch.to >= low && stretch.to <= high))
        return std::nullopt;
    const double from = outline.wrapped(stretch.from);
    const double to =
        from - stretch.from + unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd());
    return to > from ? std::optional(std::pair(from, to)) : std::nullopt;
}

double stretchLength(const Design& design, const Stretch& stretch)
{
    const Patch* patch = design.find<Patch>(stretch.patch);
    const auto range = patch ? stretchRange(stretch, patch->outline) : std::nullopt;
    return range ? ArcLength2(patch->outline).between(range->first, range->second) : 0;
}

} // namespace bolster
