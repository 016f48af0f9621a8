// What an edit means for the twins of what it changes.
#include "TwinEdits.h"

#include "FollowCurve.h"
#include "SeamsOfTwins.h"
#include "Twins.h"

#include <algorithm>
#include <functional>

namespace bolster::edits {

namespace {

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

PieceCutting mirroredCutting(PieceCutting cutting)
{
    if (cutting.label)
        cutting.label = PieceLabelPlace{mirroredInOutline(cutting.label->position), -cutting.label->rotation};
    return cutting;
}

void followValues(Twins& twins, const Symmetry& symmetry)
{
    if (const Members<Patch> patch(twins); patch) {
        patch.follow(&Patch::fabric);
        patch.follow(&Patch::grain, mirroredGrain);
        patch.follow(&Patch::pressure);
        patch.follow(&Patch::wrongSideOut);
        patch.follow(&Patch::allowance);
        patch.follow(&Patch::cutting, mirroredCutting);
    }
    if (const Members<HandleCurve> handle(twins); handle) {
        handle.follow(&HandleCurve::match);
        handle.follow(&HandleCurve::use);
        handle.follow(&HandleCurve::orientation,
                      [&](const Orientation& o) { return mirroredOrientation(o, symmetry); });
    }
    if (const Members<InternalLine> line(twins); line) {
        line.follow(&InternalLine::purpose);
        line.follow(&InternalLine::use);
    }
    if (const Members<FancySeam> fancy(twins); fancy) {
        fancy.follow(&FancySeam::use);
        fancy.follow(&FancySeam::width);
        fancy.follow(&FancySeam::depth);
        fancy.follow(&FancySeam::profile);
        fancy.follow(&FancySeam::trim);
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
    Design whole = withTwinSeams(before, Follower(before, now).result());
    whole = withTwinDrawings(before, withTwinSewing(before, whole));
    return editBetween(before, whole, std::move(edit.verb));
}

} // namespace bolster::edits
