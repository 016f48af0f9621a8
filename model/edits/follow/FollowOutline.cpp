// What was snapped to an outline keeps its place on it.
#include "FollowEdits.h"

#include "EditHelpers.h"
#include "OutlinePlaces.h"
#include "PatchPoints.h"
#include "TwinEdits.h"

#include <algorithm>
#include <map>

namespace bolster::edits {

namespace {

/// One drawn curve, before the edit and with it.
class OutlineFollower {
public:
    OutlineFollower(const OutlinePlaces& places, const BSpline2& outline, const BSpline2& before,
                    const BSpline2& now)
        : m_places(places)
        , m_outline(outline)
        , m_before(before)
        , m_points(now.points())
        , m_taken(m_points.size())
    {
        for (std::size_t i = 0; i < m_points.size(); ++i)
            m_taken[i] = m_points[i] != before.points()[i];
    }

    std::vector<Vec2> result()
    {
        const std::vector<char> moved = m_taken;
        std::vector<Vec2> steps(m_points.size(), Vec2::Zero());
        for (std::size_t i = 0; i < m_points.size(); ++i)
            if (const auto t = moved[i] ? std::nullopt : m_places.parameter(m_points[i])) {
                steps[i] = m_outline.at(m_outline.wrapped(*t)) - m_points[i];
                m_taken[i] = true;
            }
        if (!m_before.closed()) {
            bend(steps, false);
            bend(steps, true);
        }
        for (std::size_t i = 0; i < m_points.size(); ++i)
            m_points[i] += steps[i];
        return std::move(m_points);
    }

private:
    /// The points between an end and the first one that it does not shape come along in part: what is straight
    /// there stays straight.
    void bend(std::vector<Vec2>& steps, bool last) const
    {
        const std::size_t count = steps.size();
        const auto degree = static_cast<std::size_t>(m_before.degree());
        const auto at = [&](std::size_t k) { return last ? count - 1 - k : k; };
        for (std::size_t k = 1; k < degree && k + 1 < count && !m_taken[at(k)]; ++k)
            steps[at(k)] += (1 - static_cast<double>(k) / static_cast<double>(degree)) * steps[at(0)];
    }

    const OutlinePlaces& m_places;
    const BSpline2& m_outline;
    const BSpline2& m_before;
    std::vector<Vec2> m_points;
    std::vector<char> m_taken; ///< moved by the edit, or on the outline
};

/// Nothing when the curve was redrawn: then it is where the edit wants it.
ElementPtr followed(const OutlinePlaces& places, const BSpline2& outline, const Element& before,
                    const ElementPtr& now)
{
    const BSpline2 &old = patchCurve(before)->curve, &curve = patchCurve(*now)->curve;
    if (old.degree() != curve.degree() || old.closed() != curve.closed() || old.knots() != curve.knots())
        return nullptr;
    std::vector<Vec2> points = OutlineFollower(places, outline, old, curve).result();
    const bool same = points == curve.points();
    if (same || BSpline2::problem(curve.degree(), curve.closed(), points, curve.knots()))
        return nullptr;
    return withPlaneCurve(*now, curve.withPoints(std::move(points)));
}

/// The element with the points that lie on outlines, and that the edit did not move itself, where they are now.
ElementPtr followedPoints(const std::map<ElementId, OutlinePlaces>& outlines, const Design& now,
                          const Element& before, const ElementPtr& element)
{
    std::vector<PatchPoint> old;
    eachPatchPoint(before, [&](const PatchPoint& point) { old.push_back(point); });
    if (old.empty())
        return nullptr;
    Element moved = *element;
    std::size_t next = 0;
    eachPatchPoint(moved, [&](PatchPoint& point) {
        const std::size_t i = next++;
        const auto places = outlines.find(point.patch);
        if (places == outlines.end() || i >= old.size() || old[i] != point)
            return;
        const BSpline2& outline = now.find<Patch>(point.patch)->outline;
        if (const auto t = places->second.parameter(point.position))
            point.position = outline.at(outline.wrapped(*t));
    });
    return moved == *element ? nullptr : makeElement(std::move(moved));
}

/// Whether the edit is a cut or a joint: patches come or go while others get other knots.
bool addsOrRemovesPatches(const Design& before, const Edit& edit)
{
    return std::ranges::any_of(edit.changes, [&](const Change& change) {
        const bool is = change.after && std::holds_alternative<Patch>(*change.after);
        return is != (before.find<Patch>(change.id) != nullptr);
    });
}

/// The outlines that the edit changes, with where they were; only those whose parameters have kept their meaning.
std::map<ElementId, OutlinePlaces> changedOutlines(const Design& before, const Edit& edit)
{
    const bool cut = addsOrRemovesPatches(before, edit);
    std::map<ElementId, OutlinePlaces> changed;
    for (const Change& change : edit.changes) {
        const Patch* old = before.find<Patch>(change.id);
        const Patch* now = change.after ? std::get_if<Patch>(change.after.get()) : nullptr;
        if (!old || !now || old->outline.empty() || now->outline.empty() || old->outline == now->outline)
            continue;
        const bool linked = now->twin && (!old->twin || old->twin->of != now->twin->of);
        if (!linked && !(cut && old->outline.knots() != now->outline.knots()))
            changed.emplace(change.id, old->outline);
    }
    return changed;
}

Edit withWhatLiesOnOutlines(const Design& before, Edit edit)
{
    const std::map<ElementId, OutlinePlaces> outlines = changedOutlines(before, edit);
    if (outlines.empty())
        return edit;
    const Design now = before.with(edit);
    const auto take = [&](ElementId id, const ElementPtr& old, ElementPtr moved) {
        std::erase_if(edit.changes, [id](const Change& change) { return change.id == id; });
        edit.changes.push_back({id, old, std::move(moved)});
    };
    for (const auto& [id, element] : now.elements()) {
        if (const ElementPtr old = before.element(id); old && old->index() == element->index())
            if (ElementPtr moved = followedPoints(outlines, now, *old, element))
                take(id, old, std::move(moved));
        const PatchCurve* drawn = patchCurve(*element);
        const ElementPtr old = drawn ? before.element(id) : nullptr;
        const auto places = drawn ? outlines.find(drawn->patch) : outlines.end();
        if (places == outlines.end() || !old || old->index() != element->index() ||
            patchCurve(*old)->patch != drawn->patch)
            continue;
        if (ElementPtr moved = followed(places->second, now.find<Patch>(drawn->patch)->outline, *old, element))
            take(id, old, std::move(moved));
    }
    return edit;
}

} // namespace

Edit withFollowers(const Design& before, Edit edit)
{
    if (edit.empty())
        return edit;
    edit = withTwins(before, withWhatLiesOnOutlines(before, std::move(edit)));
    // What lies on the outline of a twin need not have a twin itself.
    return withWhatLiesOnOutlines(before, std::move(edit));
}

} // namespace bolster::edits
