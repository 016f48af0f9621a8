// What an edit means for the twins of what it changes.
#include "TwinEdits.h"

#include "SeamsOfTwins.h"
#include "Twins.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace bolster::edits {

namespace {

template <int Dim>
using Curve = BSpline<Dim>;

/// One curve of two twins, before and after the edit.
template <int Dim>
struct CurvePair {
    Curve<Dim> before[2];
    Curve<Dim> now[2];
    std::set<int> released; ///< of this curve, numbered from 0
};

template <int Dim>
bool sameKind(const Curve<Dim>& a, const Curve<Dim>& b)
{
    return a.degree() == b.degree() && a.closed() == b.closed() && a.knots() == b.knots();
}

template <int Dim>
bool moved(const CurvePair<Dim>& pair, int side, int point)
{
    const auto i = static_cast<std::size_t>(point);
    return pair.now[side].points()[i] != pair.before[side].points()[i];
}

template <int Dim>
bool allMoved(const CurvePair<Dim>& pair, int side)
{
    for (int i = 0; i < pair.now[side].pointCount(); ++i)
        if (!moved(pair, side, i))
            return false;
    return true;
}

template <int Dim>
Curve<Dim> withPointsIfValid(const Curve<Dim>& curve, std::vector<typename Curve<Dim>::Point> points)
{
    const bool valid = !Curve<Dim>::problem(curve.degree(), curve.closed(), points, curve.knots());
    return valid ? curve.withPoints(std::move(points)) : curve;
}

/// Points that moved take along those of the other side.
template <int Dim, class Mirror>
void followPoints(CurvePair<Dim>& pair, const Mirror& mirror)
{
    std::vector<typename Curve<Dim>::Point> points[2] = {pair.now[0].points(), pair.now[1].points()};
    const bool whole[2] = {allMoved(pair, 0), allMoved(pair, 1)};
    for (int i = 0; i < pair.now[0].pointCount(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const bool first = moved(pair, 0, i);
        const bool second = moved(pair, 1, i);
        const int from = first ? 0 : 1;
        if (!first && !second)
            continue;
        auto& other = points[1 - from][at];
        const auto place = mirror(points[from][at]);
        if (!pair.released.contains(i)) {
            if ((place - other).norm() > mirrorTolerance)
                other = place;
        } else if (whole[from] && !whole[1 - from] && !(first && second)) {
            other += place - mirror(pair.before[from].points()[at]);
        }
    }
    for (const int side : {0, 1})
        pair.now[side] = withPointsIfValid(pair.now[side], std::move(points[side]));
}

/// The curve `before` with the knots that `now` has more, if that is all the difference; else nothing.
template <int Dim>
std::optional<Curve<Dim>> withSameKnots(const Curve<Dim>& other, const Curve<Dim>& before, const Curve<Dim>& now)
{
    std::vector<double> added;
    std::set_difference(now.knots().begin(), now.knots().end(), before.knots().begin(), before.knots().end(),
                        std::back_inserter(added));
    if (!sameKind(other, before) || added.empty() || now.pointCount() <= before.pointCount())
        return std::nullopt;
    Curve<Dim> check = before;
    Curve<Dim> result = other;
    for (const double knot : added) {
        check = check.withKnot(knot);
        result = result.withKnot(knot);
    }
    return check == now && sameKind(result, now) ? std::optional(result) : std::nullopt;
}

/// Where the released points of a curve are found again after its points changed in number, by their parameters.
template <int Dim>
std::map<int, int> foundAgain(const std::set<int>& released, const Curve<Dim>& before, const Curve<Dim>& now)
{
    std::map<int, int> result; // new index by old one
    const bool same = sameKind(before, now);
    for (const int old : released) {
        if (old >= before.pointCount())
            continue;
        const double parameter = before.parameterOfPoint(old);
        if (same)
            result.emplace(old, old);
        for (int i = 0; i < now.pointCount() && !same; ++i)
            if (std::abs(now.parameterOfPoint(i) - parameter) <= 1e-9 * before.period())
                result.emplace(old, i);
    }
    return result;
}

/// The side `to` gets the points that the other one has now.
template <int Dim, class Mirror>
void followShape(CurvePair<Dim>& pair, int to, const Mirror& mirror)
{
    using Point = typename Curve<Dim>::Point;
    const Curve<Dim>& before = pair.before[1 - to];
    const Curve<Dim>& now = pair.now[1 - to];
    if (now.empty()) { // a handle without a target
        pair.now[to] = now;
        pair.released.clear();
        return;
    }
    std::vector<Point> points;
    for (const Point& point : now.points())
        points.push_back(mirror(point));
    const std::map<int, int> kept = foundAgain(pair.released, before, now);
    std::set<int> released;
    if (const auto refined = pair.released.empty() ? std::nullopt : withSameKnots(pair.before[to], before, now)) {
        // The other one keeps its own shape where it is released; what that mixes is an exception, too.
        for (std::size_t i = 0; i < points.size(); ++i) {
            if ((refined->points()[i] - points[i]).norm() <= mirrorTolerance)
                continue;
            points[i] = refined->points()[i];
            released.insert(static_cast<int>(i));
        }
    } else {
        for (const auto& [old, found] : kept)
            if (old < pair.before[to].pointCount())
                points[static_cast<std::size_t>(found)] = pair.before[to].points()[static_cast<std::size_t>(old)];
    }
    for (const auto& [old, found] : kept)
        released.insert(found);
    if (Curve<Dim>::problem(now.degree(), now.closed(), points, now.knots()))
        return;
    pair.now[to] = now.withPoints(std::move(points));
    pair.released = std::move(released);
}

template <int Dim, class Mirror>
bool alike(const CurvePair<Dim>& pair, const Mirror& mirror)
{
    if (!sameKind(pair.now[0], pair.now[1]))
        return false;
    for (int i = 0; i < pair.now[0].pointCount(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (!pair.released.contains(i) &&
            (mirror(pair.now[0].points()[at]) - pair.now[1].points()[at]).norm() > mirrorTolerance)
            return false;
    }
    return true;
}

/// `anew`: the second is not yet what the first makes of it, even if neither changed.
template <int Dim, class Mirror>
void followCurve(CurvePair<Dim>& pair, bool anew, const Mirror& mirror)
{
    const bool changed[2] = {!(pair.before[0] == pair.now[0]), !(pair.before[1] == pair.now[1])};
    if (!(changed[0] || changed[1] || anew) || alike(pair, mirror))
        return;
    const bool kept[2] = {sameKind(pair.before[0], pair.now[0]), sameKind(pair.before[1], pair.now[1])};
    const bool secondLeads = (changed[1] && !changed[0]) || (kept[0] && !kept[1]);
    if (kept[0] && kept[1] && sameKind(pair.now[0], pair.now[1]) && !anew)
        followPoints(pair, mirror);
    else
        followShape(pair, secondLeads ? 0 : 1, mirror);
}

/// Two twins, the original first, before and after the edit.
struct Twins {
    ElementPtr before[2];
    Element now[2];
    std::set<int> released;
};

/// The curve that `find` gets of each of them; `first` is the number of its first point in Twin::released.
template <int Dim, class Find, class Mirror>
void followCurves(Twins& twins, int first, bool anew, const Find& find, const Mirror& mirror)
{
    CurvePair<Dim> pair;
    for (const int side : {0, 1}) {
        pair.before[side] = *find(*twins.before[side]);
        pair.now[side] = *find(twins.now[side]);
    }
    const auto from = twins.released.lower_bound(first);
    const auto to = twins.released.lower_bound(first + firstTwinSpacePoint);
    for (auto point = from; point != to; ++point)
        pair.released.insert(*point - first);
    followCurve(pair, anew, mirror);

    twins.released.erase(from, to);
    for (const int point : pair.released)
        twins.released.insert(first + point);
    for (const int side : {0, 1}) {
        if constexpr (Dim == 2)
            twins.now[side] = *withPlaneCurve(twins.now[side], pair.now[side]);
        else
            twins.now[side] = *withSpaceCurve(twins.now[side], pair.now[side]);
    }
}

/// Members that have changed on one side are taken over by the other.
template <class T>
class Members {
public:
    Members(Twins& twins)
        : m_before{std::get_if<T>(twins.before[0].get()), std::get_if<T>(twins.before[1].get())}
        , m_now{std::get_if<T>(&twins.now[0]), std::get_if<T>(&twins.now[1])}
    {}

    explicit operator bool() const { return m_now[0]; }

    template <class V, class Base, class Mirror = std::identity>
    void follow(V Base::*member, const Mirror& mirror = {}) const
    {
        V& a = m_now[0]->*member;
        V& b = m_now[1]->*member;
        const int from = !(m_before[0]->*member == a) ? 0 : 1;
        if ((from == 1 && m_before[1]->*member == b) || mirror(a) == b || a == mirror(b))
            return;
        (from == 0 ? b : a) = mirror(from == 0 ? a : b);
    }

private:
    const T* m_before[2];
    T* m_now[2];
};

void followValues(Twins& twins, const Symmetry& symmetry)
{
    if (const Members<Patch> patch(twins); patch) {
        patch.follow(&Patch::fabric);
        patch.follow(&Patch::grain, mirroredGrain);
        patch.follow(&Patch::pressure);
        patch.follow(&Patch::wrongSideOut);
    }
    if (const Members<HandleCurve> handle(twins); handle) {
        handle.follow(&HandleCurve::match);
        handle.follow(&HandleCurve::orientation,
                      [&](const Orientation& o) { return mirroredOrientation(o, symmetry); });
    }
    if (const Members<FancySeam> fancy(twins); fancy) {
        fancy.follow(&FancySeam::width);
        fancy.follow(&FancySeam::depth);
        fancy.follow(&FancySeam::profile);
    }
}

/// Whether the link between these two is there.
bool sameLink(const std::map<ElementId, ElementId>& pairs, ElementId follower, ElementId original)
{
    const auto found = pairs.find(follower);
    return found != pairs.end() && found->second == original;
}

/// Links that the edit broke or copied are dropped, and new ones between what is not alike: a patch that was pasted
/// may name another one by chance. What the design had before and was no good stays as it was read.
Design withoutBrokenLinks(const Design& before, const Design& now)
{
    const auto heldBefore = twinPairs(before);
    const auto holds = twinPairs(now);
    Edit edit;
    for (const auto& [id, element] : now.elements()) {
        if (!twinLink(*element))
            continue;
        const auto pair = holds.find(id);
        const bool broken = pair == holds.end() && (before.element(id) != element || heldBefore.contains(id));
        const bool unlike = pair != holds.end() && !sameLink(heldBefore, id, pair->second) &&
                            unlikePoints(*now.element(pair->second), *element, symmetryOf(now)) != 0;
        if (broken || unlike)
            edit.changes.push_back({id, element, withTwinLink(*element, std::nullopt)});
    }
    return now.with(edit);
}

class Follower {
public:
    Follower(const Design& before, const Design& now)
        : m_before(before)
        , m_now(now)
        , m_symmetry(symmetryOf(now))
        , m_planeMoved(!(symmetryOf(before) == m_symmetry))
    {}

    Design result() const
    {
        const auto pairsBefore = twinPairs(m_before);
        Edit edit;
        for (const auto& [follower, original] : twinPairs(m_now)) {
            const bool touched = m_planeMoved || changed(original) || changed(follower);
            const bool sameKind = touched && sameLink(pairsBefore, follower, original) && // new ones are alike
                                  m_before.element(follower)->index() == m_now.element(follower)->index();
            if (sameKind)
                add(edit, original, follower);
        }
        return m_now.with(edit);
    }

private:
    bool changed(ElementId id) const { return m_before.element(id) != m_now.element(id); }

    void add(Edit& edit, ElementId original, ElementId follower) const
    {
        const ElementId ids[2] = {original, follower};
        Twins twins;
        for (const int side : {0, 1}) {
            twins.before[side] = m_before.element(ids[side]);
            twins.now[side] = *m_now.element(ids[side]);
        }
        const Twin link = *twinLink(twins.now[1]);
        twins.released = {link.released.begin(), link.released.end()};
        const bool flat = planeCurve(twins.now[0]);
        if (flat)
            followCurves<2>(twins, 0, false, planeCurve, mirroredInOutline);
        if (spaceCurve(twins.now[0]))
            followCurves<3>(twins, flat ? firstTwinSpacePoint : 0, m_planeMoved, spaceCurve,
                            [this](const Vec3& point) { return m_symmetry.mirrored(point); });
        followValues(twins, m_symmetry);
        if (std::vector<int> released(twins.released.begin(), twins.released.end()); released != link.released)
            twins.now[1] = *withTwinLink(twins.now[1], Twin{link.of, std::move(released)});
        for (const int side : {0, 1})
            if (!(twins.now[side] == *m_now.element(ids[side])))
                edit.changes.push_back(
                    {ids[side], nullptr, std::make_shared<const Element>(std::move(twins.now[side]))});
    }

    const Design& m_before;
    const Design& m_now;
    Symmetry m_symmetry;
    bool m_planeMoved;
};

bool hasLinks(const Design& design)
{
    const auto& elements = design.elements();
    return std::any_of(elements.begin(), elements.end(), [](const auto& entry) { return twinLink(*entry.second); });
}

} // namespace

Edit withTwins(const Design& before, Edit edit)
{
    const Design asked = before.with(edit);
    if (edit.empty() || !(hasLinks(before) || hasLinks(asked)))
        return edit;
    const Design now = withoutBrokenLinks(before, asked);
    return editBetween(before, withTwinSeams(before, Follower(before, now).result()), std::move(edit.verb));
}

} // namespace bolster::edits
