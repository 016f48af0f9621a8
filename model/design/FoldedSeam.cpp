#include "FoldedSeam.h"

#include <cmath>

namespace bolster {

namespace {

constexpr double sameTip = 1e-6; // mm

} // namespace

std::optional<FoldedSides> foldedSides(const Design& design, const Seam& seam)
{
    const Patch* patch = design.find<Patch>(seam.a.patch);
    if (!patch || seam.b.patch != seam.a.patch || patch->outline.empty() || !seam.reversed)
        return std::nullopt;
    for (const double end : {seam.a.from, seam.a.to, seam.b.from, seam.b.to})
        if (!std::isfinite(end))
            return std::nullopt;
    const auto at = [&](double t) { return patch->outline.at(patch->outline.wrapped(t)); };
    const auto meet = [&](const Stretch& one, const Stretch& two) {
        return (at(one.to) - at(two.from)).norm() < sameTip;
    };
    if (meet(seam.a, seam.b))
        return FoldedSides{seam.a.patch, seam.a, seam.b, at(seam.a.to)};
    if (meet(seam.b, seam.a))
        return FoldedSides{seam.a.patch, seam.b, seam.a, at(seam.b.to)};
    return std::nullopt;
}

} // namespace bolster
