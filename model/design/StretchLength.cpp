#include "StretchLength.h"

#include "ArcLength.h"

#include <algorithm>

namespace bolster {

double stretchLength(const Design& design, const Stretch& stretch)
{
    const Patch* patch = design.find<Patch>(stretch.patch);
    if (!patch || patch->outline.empty())
        return 0;
    const BSpline2& outline = patch->outline;
    // A closed curve may be addressed from 0 or from its first knot.
    const auto lies = [&](double t) {
        return t >= std::min(0.0, outline.domainStart()) && t <= std::max(outline.period(), outline.domainEnd());
    };
    if (!lies(stretch.from) || !lies(stretch.to))
        return 0;
    return ArcLength2(outline).between(
        stretch.from, unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd()));
}

} // namespace bolster
