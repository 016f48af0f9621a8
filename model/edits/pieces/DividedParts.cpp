#include "DividedParts.h"

#include "MatchedRange.h"
#include "NeedlessKnots.h"
#include "PlaneCurves.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bolster::edits {

namespace {

constexpr double meetingDistance = 0.01; // mm
constexpr double equalShares = 1e-4;     // lengths are sums

/// A range of parameters that two others make up, the second one behind the first; nothing when they don't meet.
template <int Dim>
std::optional<std::pair<double, double>> rangeOfBoth(const BSpline<Dim>& curve, std::pair<double, double> first,
                                                     std::pair<double, double> second)
{
    const double start = curve.domainStart(), end = curve.domainEnd(), slack = 1e-9 * curve.period();
    const double gap = second.first - first.second;
    if (std::abs(curve.closed() ? std::remainder(gap, curve.period()) : gap) > slack)
        return std::nullopt;
    const double sum = unwrappedEnd(first.first, first.second, start, end) - first.first +
                       unwrappedEnd(second.first, second.second, start, end) - second.first;
    if (curve.closed() && sum > curve.period() - slack)
        return std::nullopt; // all around: where it began would be lost
    return std::pair(first.first, second.second);
}

/// How much of both the first one takes, as the match counts.
template <int Dim>
double shareOfFirst(const BSpline<Dim>& curve, std::pair<double, double> first, std::pair<double, double> second,
                    Match match)
{
    const auto extent = [&](const std::pair<double, double>& range) {
        const MatchedRange<Dim> matched(curve, range.first, range.second, match);
        return match == Match::Length ? matched.total() : matched.to() - matched.from();
    };
    const double one = extent(first), two = extent(second);
    return one + two > 0 ? one / (one + two) : 0;
}

std::optional<Orientation> orientationOfBoth(const Orientation& first, const Orientation& second, double share)
{
    const std::size_t count = first.directions.size();
    if (first == second && count < 2)
        return first;
    if (first.kind != second.kind || first.weight != second.weight || count != second.directions.size() ||
        count < 2)
        return std::nullopt;
    Orientation both = first;
    for (std::size_t k = 0; k < count; ++k) {
        const double at = static_cast<double>(k) / static_cast<double>(count - 1);
        const Vec3 direction = at < share ? first.at(std::min(at / share, 1.0))
                                          : second.at(std::clamp((at - share) / (1 - share), 0.0, 1.0));
        if (direction.norm() > 0)
            both.directions[k] = direction;
    }
    return both;
}

/// One open curve of two of which the first ends where the second begins.
template <int Dim>
std::optional<BSpline<Dim>> curveOfBoth(const BSpline<Dim>& first, const BSpline<Dim>& second)
{
    if (first.empty() || second.empty() || first.closed() || second.closed() || first.degree() != second.degree() ||
        (first.points().back() - second.points().front()).norm() > meetingDistance)
        return std::nullopt;
    auto points = first.points();
    points.back() = (points.back() + second.points().front()) / 2;
    points.insert(points.end(), second.points().begin() + 1, second.points().end());
    std::vector<double> knots = first.knots();
    knots.pop_back();
    const double shift = first.domainEnd() - second.domainStart();
    for (auto knot = second.knots().begin() + second.degree() + 1; knot != second.knots().end(); ++knot)
        knots.push_back(*knot + shift);
    if (BSpline<Dim>::problem(first.degree(), false, points, knots))
        return std::nullopt;
    return withoutNeedlessKnots(BSpline<Dim>(first.degree(), false, std::move(points), std::move(knots)),
                                first.domainEnd());
}

class Joining {
public:
    Joining(const Design& before, ElementId merged, ElementId gone, std::span<const double> joints,
            EditBuilder& builder)
        : m_before(before)
        , m_merged(merged)
        , m_gone(gone)
        , m_outline(builder.now().find<Patch>(merged)->outline)
        , m_joints(joints)
        , m_builder(builder)
    {}

    template <class T>
    void stretches()
    {
        std::vector<ElementId> ids;
        m_builder.now().each<T>([&](ElementId id, const T& value) {
            if (touchesJoint(value))
                ids.push_back(id);
        });
        Pairs pairs;
        for (const ElementId first : ids)
            for (const ElementId second : ids)
                pairs.emplace_back(first, second);
        join<T>(pairs);
    }

    template <class T>
    void drawn()
    {
        std::vector<Drawn> here, there;
        m_builder.now().each<T>([&](ElementId id, const T& value) {
            const T* old = value.patch == m_merged && !value.curve.empty() ? m_before.find<T>(id) : nullptr;
            if (old && (old->patch == m_merged || old->patch == m_gone))
                (old->patch == m_merged ? here : there)
                    .push_back({id, value.curve.points().front(), value.curve.points().back()});
        });
        Pairs pairs;
        if constexpr (std::is_same_v<T, HandleCurve>) {
            addMeeting(here, &Drawn::last, there, &Drawn::first, pairs);
            addMeeting(there, &Drawn::last, here, &Drawn::first, pairs);
        } else {
            addMeeting(here, &Drawn::first, there, &Drawn::first, pairs);
        }
        join<T>(pairs);
    }

private:
    using Pairs = std::vector<std::pair<ElementId, ElementId>>;

    /// What is looked at of thousands before anything else.
    struct Drawn {
        ElementId id{};
        Vec2 first, last;
    };

    /// Those of which one ends where the other begins. By x first: there may be thousands.
    static void addMeeting(const std::vector<Drawn>& firsts, Vec2 Drawn::*end, const std::vector<Drawn>& seconds,
                           Vec2 Drawn::*begin, Pairs& pairs)
    {
        std::multimap<double, const Drawn*> byX;
        for (const Drawn& second : seconds)
            byX.emplace((second.*begin).x(), &second);
        for (const Drawn& first : firsts) {
            const Vec2& at = first.*end;
            const auto last = byX.upper_bound(at.x() + meetingDistance);
            for (auto near = byX.lower_bound(at.x() - meetingDistance); near != last; ++near)
                if ((near->second->*begin - at).norm() <= meetingDistance)
                    pairs.emplace_back(first.id, near->second->id);
        }
    }

    /// What two become takes the place of the one with the smaller id; the other goes. It may meet a third one.
    template <class T>
    void join(const Pairs& pairs)
    {
        std::map<ElementId, ElementId> became;
        const auto now = [&](ElementId id) {
            for (auto next = became.find(id); next != became.end(); next = became.find(id))
                id = next->second;
            return id;
        };
        for (const auto& [from, to] : pairs) {
            const ElementId first = now(from), second = now(to);
            if (first == second) {
                if constexpr (std::is_same_v<T, HandleCurve>)
                    closeRing(first);
                continue;
            }
            const T *one = m_builder.now().find<T>(first), *two = m_builder.now().find<T>(second);
            std::optional<T> whole = one && two ? both(*one, *two) : std::nullopt;
            if (!whole)
                continue;
            if constexpr (std::is_base_of_v<PatchCurve, T>)
                if (second < first)
                    std::tie(whole->name, whole->twin) = std::tie(two->name, two->twin);
            m_builder.replace(std::min(first, second), std::move(*whole));
            m_builder.remove(std::max(first, second));
            became[std::max(first, second)] = std::min(first, second);
        }
    }

    /// All of its parts are one, and it ends where it begins.
    void closeRing(ElementId id)
    {
        const auto isRing = [](const auto& curve) {
            return !curve.empty() && !curve.closed() &&
                   (curve.points().front() - curve.points().back()).norm() <= meetingDistance;
        };
        HandleCurve ring = *m_builder.now().find<HandleCurve>(id);
        if (!isRing(ring.curve) || (ring.hasTarget() && !isRing(ring.target)))
            return;
        ring.curve = closedCurve(ring.curve);
        if (ring.hasTarget())
            ring.target = closedCurve(ring.target);
        m_builder.replace(id, std::move(ring));
    }

    bool isJoint(double t) const
    {
        return std::ranges::any_of(m_joints, [&](double joint) {
            return std::abs(std::remainder(t - joint, m_outline.period())) <= 1e-9 * m_outline.period();
        });
    }
    bool touchesJoint(const Stretch& stretch) const
    {
        return stretch.patch == m_merged && (isJoint(stretch.from) || isJoint(stretch.to));
    }
    bool touchesJoint(const Seam& seam) const { return touchesJoint(seam.a) || touchesJoint(seam.b); }
    template <class T>
    bool touchesJoint(const T& held) const
    {
        return touchesJoint(held.stretch);
    }

    /// Nothing if they don't follow each other in this order, on the merged patch at a joint.
    std::optional<Stretch> both(const Stretch& first, const Stretch& second) const
    {
        const Patch* patch = m_builder.now().find<Patch>(first.patch);
        if (!patch || patch->outline.empty() || first.patch != second.patch ||
            (first.patch == m_merged && !isJoint(first.to)))
            return std::nullopt;
        const auto range = rangeOfBoth(patch->outline, {first.from, first.to}, {second.from, second.to});
        return range ? std::optional(Stretch{first.patch, range->first, range->second}) : std::nullopt;
    }
    double share(const Stretch& first, const Stretch& second, Match match) const
    {
        const BSpline2& outline = m_builder.now().find<Patch>(first.patch)->outline;
        return shareOfFirst(outline, {first.from, first.to}, {second.from, second.to}, match);
    }

    std::optional<Seam> both(const Seam& first, const Seam& second) const
    {
        Seam rest = second;
        std::tie(rest.a, rest.b, rest.ease) = std::tie(first.a, first.b, first.ease);
        // With itself: there "the first one" of a side would not be said clearly.
        if (rest != first || first.a.patch == first.b.patch)
            return std::nullopt;
        const Stretch &b0 = first.reversed ? second.b : first.b, &b1 = first.reversed ? first.b : second.b;
        const auto a = both(first.a, second.a), b = both(b0, b1);
        if (!a || !b)
            return std::nullopt;
        const double onB = share(b0, b1, first.match);
        if (std::abs(share(first.a, second.a, first.match) - (first.reversed ? 1 - onB : onB)) > equalShares)
            return std::nullopt;
        Seam whole = first;
        std::tie(whole.a, whole.b, whole.ease) = std::tuple(*a, *b, first.ease + second.ease);
        return whole;
    }

    std::optional<FixationSeam> both(const FixationSeam& first, const FixationSeam& second) const
    {
        FixationSeam rest = second;
        std::tie(rest.stretch, rest.curveRange, rest.orientation) =
            std::tie(first.stretch, first.curveRange, first.orientation);
        const auto stretch = rest == first ? both(first.stretch, second.stretch) : std::nullopt;
        if (!stretch)
            return std::nullopt;
        FixationSeam whole = first;
        whole.stretch = *stretch;
        if (first.hasCurve() && !joinRanges(first, second, whole))
            return std::nullopt;
        const auto leaning = orientationOfBoth(first.orientation, second.orientation,
                                               share(first.stretch, second.stretch, Match::Length));
        if (!leaning)
            return std::nullopt;
        whole.orientation = *leaning;
        return whole;
    }

    bool joinRanges(const FixationSeam& first, const FixationSeam& second, FixationSeam& whole) const
    {
        const auto* rail = m_builder.now().find<FixationCurve>(first.curve);
        if (!rail || rail->curve.empty() || !first.curveRange || !second.curveRange)
            return false;
        const auto &c0 = *(first.reversed ? second : first).curveRange,
                   &c1 = *(first.reversed ? first : second).curveRange;
        const auto range = rangeOfBoth(rail->curve, c0, c1);
        if (!range)
            return false;
        const double onCurve = shareOfFirst(rail->curve, c0, c1, first.match);
        if (std::abs(share(first.stretch, second.stretch, first.match) - (first.reversed ? 1 - onCurve : onCurve)) >
            equalShares)
            return false;
        whole.curveRange = range;
        if (*range == std::pair(rail->curve.domainStart(), rail->curve.domainEnd()))
            whole.curveRange.reset();
        return true;
    }

    /// Trims and allowances.
    template <class T>
    std::optional<T> both(const T& first, const T& second) const
    {
        T whole = first;
        whole.stretch = second.stretch;
        const auto stretch = whole == second ? both(first.stretch, second.stretch) : std::nullopt;
        if (!stretch)
            return std::nullopt;
        whole.stretch = *stretch;
        return whole;
    }

    std::optional<HandleCurve> both(const HandleCurve& first, const HandleCurve& second) const
    {
        HandleCurve rest = second;
        std::tie(rest.name, rest.curve, rest.twin, rest.target, rest.orientation, rest.note) =
            std::tie(first.name, first.curve, first.twin, first.target, first.orientation, first.note);
        if (rest != first || first.hasTarget() != second.hasTarget())
            return std::nullopt;
        const auto curve = curveOfBoth(first.curve, second.curve);
        const auto target = first.hasTarget() ? curveOfBoth(first.target, second.target) : BSpline3();
        if (!curve || !target)
            return std::nullopt;
        const double one = ArcLength2(first.curve).total(), two = ArcLength2(second.curve).total();
        const auto leaning = orientationOfBoth(first.orientation, second.orientation, one / (one + two));
        if (!leaning)
            return std::nullopt;
        HandleCurve whole = first;
        std::tie(whole.curve, whole.target, whole.orientation) = std::tie(*curve, *target, *leaning);
        if (!second.note.empty() && second.note != first.note)
            whole.note.append(whole.note.empty() ? "" : "\n").append(second.note);
        return whole;
    }

    /// A cut leaves a fancy seam whole in both patches.
    std::optional<FancySeam> both(const FancySeam& first, const FancySeam& second) const
    {
        FancySeam rest = second;
        std::tie(rest.name, rest.curve, rest.twin) = std::tie(first.name, first.curve, first.twin);
        const auto &p = first.curve.points(), &q = second.curve.points();
        const bool alike = rest == first && p.size() == q.size() && first.curve.closed() == second.curve.closed() &&
                           first.curve.degree() == second.curve.degree() &&
                           std::ranges::equal(p, q, [](const Vec2& a, const Vec2& b) {
                               return (a - b).norm() <= meetingDistance;
                           });
        return alike ? std::optional(first) : std::nullopt;
    }

    const Design& m_before;
    ElementId m_merged, m_gone;
    const BSpline2 m_outline;
    std::span<const double> m_joints;
    EditBuilder& m_builder;
};

} // namespace

void joinDivided(const Design& before, ElementId merged, ElementId gone, std::span<const double> joints,
                 EditBuilder& builder)
{
    Joining joining(before, merged, gone, joints, builder);
    joining.stretches<Seam>();
    joining.stretches<FixationSeam>();
    joining.stretches<OutlineTrim>();
    joining.stretches<EdgeAllowance>();
    joining.drawn<HandleCurve>();
    joining.drawn<FancySeam>();
}

} // namespace bolster::edits
