#include "DartLegs.h"

#include "ArcLength.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double shortestLeg = 8;   // mm
constexpr double widestDart = 75;   // degrees, at the tip: wider ones are corners
constexpr double alikeLegs = 0.006; // of their length: how far they may be from mirror images
constexpr double cutLegs = 0.3;     // mm: the same, as exactly as anybody cuts
constexpr double leastAlike = 0.4;

/// How far the legs are from being mirror images, mm.
double unlike(const BSpline2& outline, double tip, double length)
{
    constexpr int samples = 8;
    const ArcLength2 along(outline);
    const auto at = [&](double s) { return outline.at(outline.wrapped(along.parameterAt(along.at(tip) + s))); };
    const Vec2 from = outline.at(outline.wrapped(tip));
    const Vec2 axis = ((at(length) - from).normalized() + (at(-length) - from).normalized()).normalized();
    double most = 0;
    for (int k = 1; k <= samples; ++k) {
        const Vec2 one = at(-length * k / samples) - from, two = at(length * k / samples) - from;
        most = std::max(most, (one - (2 * axis.dot(two) * axis - two)).norm());
    }
    return most;
}

} // namespace

std::vector<DartLegs> dartLegs(const Design& design, const std::vector<OutlineEdge>& edges)
{
    std::vector<DartLegs> found;
    for (int i = 0; i < static_cast<int>(edges.size()); ++i) {
        const OutlineEdge& first = edges[static_cast<std::size_t>(i)];
        const OutlineEdge& second = edges[static_cast<std::size_t>(first.next)];
        const double length = std::min(first.length, second.length);
        if (first.taken || second.taken || first.next == i || second.next == i || length < shortestLeg ||
            second.corner < 360 - widestDart)
            continue;
        const double exact = alikeLegs * length + cutLegs;
        const double tip = first.backwards ? first.stretch.from : first.stretch.to;
        const double off = std::max(std::abs(first.length - second.length),
                                    unlike(design.find<Patch>(first.stretch.patch)->outline, tip, length)) /
                           exact;
        if (const double fit = std::exp(-off * off); fit > leastAlike)
            found.push_back({i, first.next, fit});
    }
    return found;
}

} // namespace bolster
