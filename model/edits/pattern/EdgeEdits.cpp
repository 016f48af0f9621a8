// Edges of outlines by their lengths.
#include "ArcLength.h"
#include "EditBuilder.h"
#include "LengthEdits.h"
#include "Twins.h"

#include <algorithm>
#include <cmath>

namespace bolster::edits {

namespace {

constexpr double shortestEdge = 1e-3; // mm
constexpr double longestEdge = 1e6;   // mm
constexpr double edgeExactness = 1e-9;
constexpr int mostEdgeSweeps = 400;

/// The control point that is a corner at the parameter, or -1.
int cornerAt(const BSpline2& outline, double parameter)
{
    const double slack = 1e-9 * outline.period();
    for (const double corner : outline.corners())
        if (std::abs(corner - outline.wrapped(parameter)) <= slack)
            return outline.pointAt(corner);
    return -1;
}

std::vector<int> edgePoints(const BSpline2& outline, const Stretch& edge)
{
    const int count = outline.pointCount();
    const bool smooth = outline.corners().empty();
    const int first = smooth ? 0 : cornerAt(outline, edge.from), last = smooth ? 0 : cornerAt(outline, edge.to);
    std::vector<int> points;
    if (first < 0 || last < 0)
        return points;
    if (first == last) {
        for (int i = 0; i < count; ++i)
            points.push_back(i);
        return points;
    }
    for (int i = first;; i = (i + 1) % count) {
        points.push_back(i);
        if (i == last)
            return points;
    }
}

double lengthOfEdge(const BSpline2& outline, const Stretch& edge)
{
    return ArcLength2(outline).between(
        edge.from, unwrappedEnd(edge.from, edge.to, outline.domainStart(), outline.domainEnd()));
}

const Message notAnEdge{QT_TRANSLATE_NOOP("Message", "A side of this seam does not end at corners: its length "
                                                     "cannot be changed alone."),
                        {}};

/// Several edges that are to have one length; those that share a corner pull at it in turn until all have it.
class EdgeFit {
public:
    explicit EdgeFit(const Design& design)
        : m_design(design)
        , m_pairs(twinPairs(design))
    {}

    /// It stays as it is.
    bool pin(const Stretch& edge)
    {
        const Stretch own = original(edge);
        for (const int point : pointsOn(own))
            m_pinned.insert({own.patch, point});
        return !pointsOn(own).empty();
    }

    /// It ends at corners, so that it can be made longer alone.
    bool takes(const Stretch& edge) { return !pointsOn(original(edge)).empty(); }

    bool add(const Stretch& edge, double length)
    {
        const Target target{original(edge), length, pointsOn(original(edge))};
        const auto same = [&](const Target& other) { return other.edge == target.edge; };
        if (std::ranges::none_of(m_targets, same))
            m_targets.push_back(target);
        return !target.points.empty();
    }

    /// False when they cannot all have it.
    bool solve()
    {
        for (int sweep = 0; sweep < mostEdgeSweeps; ++sweep) {
            bool done = true;
            for (const Target& target : m_targets) {
                BSpline2& outline = m_outlines.at(target.edge.patch);
                const double now = lengthOfEdge(outline, target.edge);
                if (std::abs(now - target.length) <= edgeExactness * target.length)
                    continue;
                done = false;
                if (!(now > 0) || !scale(target, target.length / now))
                    return false;
            }
            if (done)
                return true;
        }
        return false;
    }

    Edit result(const Message& verb) const
    {
        EditBuilder builder(m_design);
        for (const auto& [id, outline] : m_outlines)
            if (Patch patch = *m_design.find<Patch>(id); !(patch.outline == outline)) {
                patch.outline = outline;
                builder.replace(id, std::move(patch));
            }
        return builder.result(verb);
    }

private:
    struct Target {
        Stretch edge;
        double length = 0;
        std::vector<int> points;
    };

    /// Of twins that are alike one stands for both: they have the same parameters, and the other one follows.
    Stretch original(Stretch edge) const
    {
        const auto pair = m_pairs.find(edge.patch);
        if (pair != m_pairs.end() && releasedPoints(m_design, edge.patch).empty())
            edge.patch = pair->second;
        return edge;
    }

    std::vector<int> pointsOn(const Stretch& edge)
    {
        const Patch* patch = m_design.find<Patch>(edge.patch);
        if (!patch || patch->outline.empty())
            return {};
        return edgePoints(m_outlines.emplace(edge.patch, patch->outline).first->second, edge);
    }

    bool scale(const Target& target, double factor)
    {
        BSpline2& outline = m_outlines.at(target.edge.patch);
        std::vector<Vec2> points = outline.points();
        const auto at = [&](int i) -> Vec2& { return points[static_cast<std::size_t>(i)]; };
        const auto pinned = [&](int i) { return m_pinned.contains({target.edge.patch, i}); };
        const int first = target.points.front(), last = target.points.back();
        if (pinned(first) && pinned(last))
            return false;
        const Vec2 middle = target.points.size() == points.size() ? Vec2(outline.boundingBox().center())
                                                                  : Vec2((at(first) + at(last)) / 2);
        const Vec2 about = pinned(first) ? at(first) : pinned(last) ? at(last) : middle;
        for (const int i : target.points)
            if (!pinned(i))
                at(i) = about + factor * (at(i) - about);
        if (BSpline2::problem(outline.degree(), outline.closed(), points, outline.knots()))
            return false;
        outline = outline.withPoints(std::move(points));
        return true;
    }

    const Design& m_design;
    std::map<ElementId, ElementId> m_pairs;
    std::map<ElementId, BSpline2> m_outlines;
    std::set<std::pair<ElementId, int>> m_pinned;
    std::vector<Target> m_targets;
};

Edit fitted(EdgeFit& fit, bool edges, const Message& verb, Message* problem)
{
    if (edges && fit.solve())
        return fit.result(verb);
    if (problem)
        *problem = !edges ? notAnEdge
                          : Message{QT_TRANSLATE_NOOP("Message", "These edges cannot have this length: they hang "
                                                                 "together."),
                                    {}};
    return {};
}

Message edgesVerb(const Design& design, std::span<const Stretch> edges, const char* one, const char* many)
{
    if (edges.size() == 1)
        return {one, {displayName(design, edges.front().patch)}};
    return {many, {std::to_string(edges.size())}};
}

} // namespace

std::vector<int> pointsOfEdge(const Design& design, const Stretch& edge)
{
    const Patch* patch = design.find<Patch>(edge.patch);
    return patch && !patch->outline.empty() ? edgePoints(patch->outline, edge) : std::vector<int>();
}

double edgeLength(const Design& design, const Stretch& edge)
{
    const Patch* patch = design.find<Patch>(edge.patch);
    return patch && !patch->outline.empty() ? lengthOfEdge(patch->outline, edge) : 0;
}

Edit setEdgeLengths(const Design& design, std::span<const Stretch> edges, double length, Message* problem)
{
    if (!(length >= shortestEdge && length <= longestEdge))
        return {};
    EdgeFit fit(design);
    bool all = true;
    for (const Stretch& edge : edges)
        all = fit.add(edge, length) && all;
    return fitted(fit, all,
                  edgesVerb(design, edges, QT_TRANSLATE_NOOP("Message", "Change the length of an edge of %1"),
                            QT_TRANSLATE_NOOP("Message", "Change the length of %1 edges")),
                  problem);
}

Edit makeEdgesEqual(const Design& design, std::span<const Stretch> edges, Message* problem)
{
    if (edges.size() < 2)
        return {};
    EdgeFit fit(design);
    bool all = fit.pin(edges.front());
    const double length = edgeLength(design, edges.front());
    for (const Stretch& edge : edges)
        all = fit.add(edge, length) && all;
    return fitted(fit, all,
                  {QT_TRANSLATE_NOOP("Message", "Make %1 edges equally long"), {std::to_string(edges.size())}},
                  problem);
}

Edit makeSeamSidesEqual(const Design& design, std::span<const ElementId> seams, Message* problem)
{
    EdgeFit fit(design);
    bool all = !seams.empty(), turned = false;
    for (const ElementId id : seams)
        if (const Seam* seam = design.find<Seam>(id)) {
            const bool second = fit.takes(seam->b) || !fit.takes(seam->a);
            const Stretch &changed = second ? seam->b : seam->a, &kept = second ? seam->a : seam->b;
            all = fit.add(changed, edgeLength(design, kept)) && all;
            turned = turned || !second;
        }
    const Message verb = seams.size() == 1
                             ? Message{QT_TRANSLATE_NOOP("Message", "Make the sides of a seam equally long"), {}}
                             : Message{QT_TRANSLATE_NOOP("Message", "Make the sides of %1 seams equally long"),
                                       {std::to_string(seams.size())}};
    Edit edit = fitted(fit, all, verb, problem);
    if (turned && !edit.empty())
        edit.note = {
            QT_TRANSLATE_NOOP("Message", "The second side ends inside an edge, so the first one was changed."), {}};
    return edit;
}

} // namespace bolster::edits
