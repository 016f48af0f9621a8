#include "DartSewing.h"

#include "MatchedRange.h"
#include "PatchMark.h"
#include "PlaneCurves.h"
#include "StretchLength.h"

#include <algorithm>
#include <cmath>

namespace bolster::edits {

namespace {

constexpr double sameEnd = 1e-6; // of parameters

/// A part of an outline, unwrapped.
struct Span {
    double from = 0;
    double to = 0;
};

bool meets(const BSpline2& on, double a, double b)
{
    return std::abs(std::remainder(a - b, on.period())) < sameEnd;
}

/// Both ends in the same turn; `to` is unwrapped.
Stretch stretchAlong(const BSpline2& outline, ElementId patch, double from, double to)
{
    const double start = inFirstTurn(outline, from), end = start + to - from;
    return {patch, start, end > outline.domainEnd() ? end - outline.period() : end};
}

/// From one end to the next place that is the other one.
Stretch stretchOver(const BSpline2& outline, ElementId patch, double from, double to)
{
    const double turns = std::ceil((from - to) / outline.period() + sameEnd);
    return stretchAlong(outline, patch, from, to + outline.period() * turns);
}

/// What a mouth leaves of a seam on another patch: the parts before and after it. The other side stays whole.
class DividedSeam {
public:
    DividedSeam(const Design& design, const Seam& seam, const DartShape& mouth)
        : m_seam(seam)
    {
        const ElementId patch = mouth.patch;
        for (Stretch Seam::*side : {&Seam::a, &Seam::b}) {
            const Stretch& stretch = seam.*side;
            Stretch Seam::*other = side == &Seam::a ? &Seam::b : &Seam::a;
            const auto* there = design.find<Patch>((seam.*other).patch);
            if (stretch.patch != patch || (seam.*other).patch == patch || !there || there->outline.empty())
                continue;
            const BSpline2& outline = design.find<Patch>(patch)->outline;
            const double end = unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd());
            for (int turn = -2; turn <= 2; ++turn) {
                const double from = mouth.from + turn * outline.period(), to = mouth.to + turn * outline.period();
                if (to > stretch.from + sameEnd && from < end - sameEnd)
                    divide(side, other, outline, {stretch.from, from}, {to, end}, there->outline);
            }
        }
    }

    /// Empty when the mouth is elsewhere, or takes all of it.
    const std::vector<Seam>& parts() const { return m_parts; }

private:
    void divide(Stretch Seam::*side, Stretch Seam::*other, const BSpline2& outline, const Span& before,
                const Span& after, const BSpline2& outlineThere)
    {
        const ArcLength2 length(outline);
        const auto lengthOf = [&](const Span& part) {
            return part.to > part.from + sameEnd ? length.between(part.from, part.to) : 0;
        };
        const double first = lengthOf(before), whole = first + lengthOf(after);
        if (!(whole > 0))
            return;
        const Stretch& there = m_seam.*other;
        const MatchedRange<2> range(outlineThere, there.from, there.to, Match::Length);
        const auto add = [&](const Span& part, double f0, double f1) {
            if (f1 <= f0)
                return;
            Seam seam = m_seam;
            seam.*side = stretchAlong(outline, (m_seam.*side).patch, part.from, part.to);
            const double g0 = m_seam.reversed ? 1 - f1 : f0, g1 = m_seam.reversed ? 1 - f0 : f1;
            seam.*other = stretchAlong(outlineThere, there.patch, range.parameter(g0), range.parameter(g1));
            seam.ease = (f1 - f0) * m_seam.ease;
            m_parts.push_back(std::move(seam));
        };
        add(before, 0, first / whole);
        add(after, first / whole, 1);
    }

    Seam m_seam;
    std::vector<Seam> m_parts;
};

/// Puts what a mouth has divided together again.
class JoinedOverMouth {
public:
    JoinedOverMouth(const Design& design, const DartShape& dart, EditBuilder& builder)
        : m_design(design)
        , m_dart(dart)
        , m_outline(builder.now().find<Patch>(dart.patch)->outline)
        , m_builder(builder)
    {}

    std::set<ElementId> done;

    void seams()
    {
        for (Stretch Seam::*side : {&Seam::a, &Seam::b})
            pairs<Seam>([side](const Seam& seam) { return seam.*side; },
                        [&](ElementId one, const Seam& x, ElementId two, const Seam& y) {
                            if (const auto whole = oneSeam(x, y, side))
                                join(one, *whole, two);
                        });
    }

    void held()
    {
        pairs<FixationSeam>([](const FixationSeam& held) { return held.stretch; },
                            [&](ElementId one, const FixationSeam& x, ElementId two, const FixationSeam& y) {
                                if (const auto whole = oneHeld(x, y))
                                    join(one, *whole, two);
                            });
    }

    /// Trims and allowances of edges.
    template <class T>
    void marks()
    {
        pairs<T>([](const T& mark) { return mark.stretch; },
                 [&](ElementId one, T x, ElementId two, T y) {
                     const Stretch whole = over(x.stretch, y.stretch);
                     x.stretch = y.stretch = whole;
                     if (x == y)
                         join(one, x, two);
                 });
    }

private:
    template <class T, class StretchOf, class Use>
    void pairs(StretchOf stretchOf, Use use)
    {
        m_design.each<T>([&](ElementId one, const T& x) {
            if (stretchOf(x).patch != m_dart.patch || !meets(m_outline, stretchOf(x).to, m_dart.from))
                return;
            m_design.each<T>([&](ElementId two, const T& y) {
                if (one != two && stretchOf(y).patch == m_dart.patch &&
                    meets(m_outline, stretchOf(y).from, m_dart.to) && !done.contains(one) && !done.contains(two))
                    use(one, x, two, y);
            });
        });
    }

    template <class T>
    void join(ElementId one, const T& whole, ElementId two)
    {
        m_builder.replace(one, whole);
        m_builder.remove(two);
        done.insert({one, two});
    }

    Stretch over(const Stretch& first, const Stretch& last) const
    {
        return stretchOver(m_outline, m_dart.patch, first.from, last.to);
    }

    /// Their other sides lie side by side on one patch.
    std::optional<Seam> oneSeam(const Seam& x, const Seam& y, Stretch Seam::*side) const
    {
        Stretch Seam::*other = side == &Seam::a ? &Seam::b : &Seam::a;
        const Stretch &first = (x.reversed ? y : x).*other, &last = (x.reversed ? x : y).*other;
        const auto* there = m_design.find<Patch>(first.patch);
        if (first.patch != last.patch || first.patch == m_dart.patch || x.reversed != y.reversed ||
            x.match != y.match || !there || there->outline.empty() || !meets(there->outline, first.to, last.from))
            return std::nullopt;
        Seam whole = x;
        whole.*side = over(x.*side, y.*side);
        whole.*other = stretchOver(there->outline, first.patch, first.from, last.to);
        whole.ease = x.ease + y.ease;
        return whole;
    }

    std::optional<FixationSeam> oneHeld(const FixationSeam& x, const FixationSeam& y) const
    {
        FixationSeam whole = x, alike = y;
        whole.stretch = alike.stretch = over(x.stretch, y.stretch);
        if (x.hasCurve()) {
            const auto* curve = m_design.find<FixationCurve>(x.curve);
            if (!curve || !x.curveRange || !y.curveRange)
                return std::nullopt;
            const auto &first = *(x.reversed ? y : x).curveRange, &last = *(x.reversed ? x : y).curveRange;
            if (std::abs(first.second - last.first) > sameEnd)
                return std::nullopt;
            whole.curveRange = {first.first, last.second};
            if (*whole.curveRange == std::pair(curve->curve.domainStart(), curve->curve.domainEnd()))
                whole.curveRange.reset(); // all of it
            alike.curveRange = whole.curveRange;
        }
        return whole == alike ? std::optional(whole) : std::nullopt;
    }

    const Design& m_design;
    const DartShape& m_dart;
    const BSpline2 m_outline; ///< without the dart
    EditBuilder& m_builder;
};

} // namespace

std::set<ElementId> divideSeams(const Design& design, const DartShape& mouth, EditBuilder& builder)
{
    std::set<ElementId> divided;
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        const std::vector<Seam> parts = DividedSeam(design, seam, mouth).parts();
        if (parts.empty())
            return;
        divided.insert(id);
        builder.replace(id, parts.front());
        for (std::size_t k = 1; k < parts.size(); ++k)
            builder.add(parts[k]);
    });
    return divided;
}

std::set<ElementId> keepNotches(const Design& design, const DartShape& mouth, EditBuilder& builder)
{
    const BSpline2 &outline = design.find<Patch>(mouth.patch)->outline,
                   &cut = builder.now().find<Patch>(mouth.patch)->outline;
    const ArcLength2 length(outline);
    const auto turned = [&](double t) {
        return t - outline.period() * std::floor((t - mouth.from) / outline.period());
    };
    std::set<double> taken; // ends that have a notch
    design.each<Notch>([&](ElementId, const Notch& notch) {
        for (const double end : {mouth.from, mouth.to})
            if (notch.place.patch == mouth.patch && meets(outline, notch.place.at, end))
                taken.insert(end);
    });
    std::set<ElementId> moved;
    design.each<Notch>([&](ElementId id, Notch notch) {
        if (notch.place.patch != mouth.patch || !std::isfinite(notch.place.at))
            return;
        const double at = turned(notch.place.at);
        if (at < mouth.from + sameEnd || at > mouth.to - sameEnd)
            return;
        const bool first = length.between(mouth.from, at) <= length.between(at, mouth.to);
        if (!taken.insert(first ? mouth.from : mouth.to).second)
            return;
        notch.place.at = cut.wrapped(first ? mouth.from : mouth.to);
        builder.replace(id, notch);
        moved.insert(id);
    });
    return moved;
}

void closeHeldGap(const DartShape& mouth, EditBuilder& builder)
{
    const Design design = builder.now();
    const BSpline2& outline = design.find<Patch>(mouth.patch)->outline;
    const auto join = [&](ElementId one, FixationSeam before, ElementId two, FixationSeam after) {
        const auto* held = design.find<FixationCurve>(before.curve);
        const double a = stretchLength(design, before.stretch), b = stretchLength(design, after.stretch);
        if (one == two || !held || after.curve != before.curve || after.reversed != before.reversed ||
            !before.curveRange || !after.curveRange || !(a > 0 && b > 0))
            return;
        FixationSeam &first = before.reversed ? after : before, &last = before.reversed ? before : after;
        const MatchedRange<3> range(held->curve, first.curveRange->first, last.curveRange->second, Match::Length);
        const double middle = held->curve.wrapped(range.parameter((before.reversed ? b : a) / (a + b)));
        first.curveRange->second = last.curveRange->first = middle;
        builder.replace(one, before);
        builder.replace(two, after);
    };
    design.each<FixationSeam>([&](ElementId one, const FixationSeam& before) {
        if (before.stretch.patch != mouth.patch || !meets(outline, before.stretch.to, mouth.from))
            return;
        design.each<FixationSeam>([&](ElementId two, const FixationSeam& after) {
            if (after.stretch.patch == mouth.patch && meets(outline, after.stretch.from, mouth.to))
                join(one, before, two, after);
        });
    });
}

std::set<ElementId> joinOverMouth(const Design& design, const DartShape& dart, EditBuilder& builder)
{
    JoinedOverMouth joined(design, dart, builder);
    joined.seams();
    joined.held();
    joined.marks<OutlineTrim>();
    joined.marks<EdgeAllowance>();
    return joined.done;
}

} // namespace bolster::edits
