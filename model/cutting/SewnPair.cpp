#include "SewnPair.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

const BSpline2* outlineOf(const Design& design, ElementId patch)
{
    const Patch* found = design.find<Patch>(patch);
    return found && !found->outline.empty() ? &found->outline : nullptr;
}

std::shared_ptr<const MatchedRange<2>> rangeOf(const BSpline2* outline, const Stretch& stretch, Match match)
{
    if (!outline || !std::isfinite(stretch.from) || !std::isfinite(stretch.to))
        return nullptr;
    auto range = std::make_shared<const MatchedRange<2>>(*outline, stretch.from, stretch.to, match);
    return range->total() > 0 ? range : nullptr;
}

std::optional<double> fractionOn(const MatchedRange<2>& range, const BSpline2& outline, double at)
{
    const double period = outline.period(), slack = 1e-9 * period;
    const double ahead = at - range.from() - period * std::floor((at - range.from() + slack) / period);
    if (ahead > range.to() - range.from() + slack)
        return std::nullopt;
    return std::clamp(range.fraction(range.from() + ahead), 0.0, 1.0);
}

/// The same distances from the middle of the stretch, walking the outline to either side.
bool isOwnMirror(const BSpline2& outline, const MatchedRange<2>& range, double share)
{
    const ArcLength2 length(outline);
    const double middle = length.at(range.from()) + range.total() / 2;
    const auto at = [&](double s) { return outline.at(outline.wrapped(length.parameterAt(s))); };
    const Vec2 centre = at(middle);
    constexpr int samples = 24;
    for (int k = 1; k <= samples; ++k) {
        const double s = length.total() / 2 * k / samples;
        const double ahead = (at(middle + s) - centre).norm(), behind = (at(middle - s) - centre).norm();
        if (std::abs(ahead - behind) > share * std::max(range.total(), std::max(ahead, behind)))
            return false;
    }
    return true;
}

} // namespace

SewnPair::SewnPair(const Design& design, const Seam& seam)
    : m_seam(seam)
    , m_outlineA(outlineOf(design, seam.a.patch))
    , m_outlineB(outlineOf(design, seam.b.patch))
    , m_a(rangeOf(m_outlineA, seam.a, seam.match))
    , m_b(rangeOf(m_outlineB, seam.b, seam.match))
{}

std::optional<double> SewnPair::fractionAt(const OutlinePlace& place) const
{
    if (place.patch == m_seam.a.patch)
        if (const auto fraction = fractionOn(*m_a, *m_outlineA, place.at))
            return fraction;
    if (place.patch == m_seam.b.patch)
        if (const auto fraction = fractionOn(*m_b, *m_outlineB, place.at))
            return m_seam.reversed ? 1 - *fraction : *fraction;
    return std::nullopt;
}

bool SewnPair::couldBe(const SewnPair& other, double share) const
{
    const auto shares = [&](ElementId patch) {
        return patch == other.m_seam.a.patch || patch == other.m_seam.b.patch;
    };
    if (!shares(m_seam.a.patch) && !shares(m_seam.b.patch))
        return false;
    return std::abs(length() - other.length()) <= share * std::max(length(), other.length());
}

bool SewnPair::couldBeTurned(double share) const
{
    return isOwnMirror(*m_outlineA, *m_a, share) || isOwnMirror(*m_outlineB, *m_b, share);
}

} // namespace bolster
