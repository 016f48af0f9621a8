// Which part of an outline a stretch means, and how long it is.
#pragma once

#include "Design.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace bolster {

/// The parameters that places of a curve may have: of a closed one from 0 or from its first knot on. Mostly these
/// are the same, but an outline with a dart may begin elsewhere.
template <int Dim>
std::pair<double, double> addressable(const BSpline<Dim>& curve)
{
    const double start = curve.domainStart(), end = curve.domainEnd();
    return curve.closed() ? std::pair(std::min(0.0, start), std::max(curve.period(), end)) : std::pair(start, end);
}

/// From the first turn on, unwrapped; nothing when the stretch does not lie on this outline.
std::optional<std::pair<double, double>> stretchRange(const Stretch& stretch, const BSpline2& outline);

/// Arc length, mm; 0 when the stretch does not lie on its outline.
double stretchLength(const Design& design, const Stretch& stretch);

} // namespace bolster
