#include "EdgeFit.h"

#include "ArcLength.h"
#include "EditBuilder.h"
#include "FoldedSeam.h"
#include "Twins.h"

#include <algorithm>
#include <cmath>

namespace bolster::edits {

namespace {

constexpr double edgeExactness = 1e-9;
constexpr int mostEdgeSweeps = 400;

/// The control point that is a corner at the parameter, or -1.
int cornerAt(const BSpline2& outline, double parameter)
{
    const double slack = 1e-9 * outline.period();
    for (const double corner : outline.corners())
        if (std::abs(std::remainder(corner - parameter, outline.period())) <= slack)
            return outline.pointAt(corner);
    return -1;
}

EdgeSurroundings surroundingsOf(const Design& design, ElementId patch, const BSpline2& outline)
{
    EdgeSurroundings around;
    const auto use = [&](const Stretch& stretch) {
        if (stretch.patch == patch && std::isfinite(stretch.from) && std::isfinite(stretch.to))
            around.used.push_back(stretch);
    };
    design.each<Seam>([&](ElementId, const Seam& seam) {
        use(seam.a);
        use(seam.b);
        const std::optional<FoldedSides> dart = foldedSides(design, seam);
        if (!dart || dart->patch != patch)
            return;
        const int from = cornerAt(outline, dart->first.from), to = cornerAt(outline, dart->second.to);
        if (from >= 0 && to >= 0 && from != to)
            around.mouths.emplace_back(from, to);
    });
    design.each<FixationSeam>([&](ElementId, const FixationSeam& held) { use(held.stretch); });
    return around;
}

} // namespace

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

EdgeFit::EdgeFit(const Design& design)
    : m_design(design)
    , m_pairs(twinPairs(design))
{}

bool EdgeFit::pin(const Stretch& edge)
{
    const Stretch own = original(edge);
    const std::vector<int> points = pointsOn(own);
    for (const int point : points)
        m_pinned.insert({own.patch, point});
    return !points.empty();
}

bool EdgeFit::takes(const Stretch& edge)
{
    return !pointsOn(original(edge)).empty();
}

bool EdgeFit::add(const Stretch& edge, double length)
{
    const Target target{original(edge), length, pointsOn(original(edge))};
    const auto same = [&](const Target& other) { return other.edge == target.edge; };
    if (std::ranges::none_of(m_targets, same))
        m_targets.push_back(target);
    return !target.points.empty();
}

bool EdgeFit::solve(Way way)
{
    for (int sweep = 0; sweep < mostEdgeSweeps; ++sweep) {
        bool done = true;
        for (const Target& target : m_targets) {
            const double now = lengthOfEdge(m_outlines.at(target.edge.patch), target.edge);
            if (std::abs(now - target.length) <= edgeExactness * target.length)
                continue;
            done = false;
            if (!(now > 0) || !change(target, now, way))
                return false;
        }
        if (done)
            return true;
    }
    return false;
}

Edit EdgeFit::result(const Message& verb) const
{
    EditBuilder builder(m_design);
    for (const auto& [id, outline] : m_outlines)
        if (Patch patch = *m_design.find<Patch>(id); !(patch.outline == outline)) {
            patch.outline = outline;
            builder.replace(id, std::move(patch));
        }
    return builder.result(verb);
}

Stretch EdgeFit::original(Stretch edge) const
{
    const auto pair = m_pairs.find(edge.patch);
    if (pair != m_pairs.end() && releasedPoints(m_design, edge.patch).empty())
        edge.patch = pair->second;
    return edge;
}

std::vector<int> EdgeFit::pointsOn(const Stretch& edge)
{
    const Patch* patch = m_design.find<Patch>(edge.patch);
    if (!patch || patch->outline.empty())
        return {};
    return edgePoints(m_outlines.emplace(edge.patch, patch->outline).first->second, edge);
}

bool EdgeFit::change(const Target& target, double now, Way way)
{
    BSpline2& outline = m_outlines.at(target.edge.patch);
    const bool whole = static_cast<int>(target.points.size()) == outline.pointCount();
    std::optional<BSpline2> changed;
    if (way == Way::Bending || whole)
        changed = scaled(target, target.length / now);
    else
        changed = (way == Way::Truing ? truedEdge : edgeAboutMiddle)(outline, target.points, target.length,
                                                                     surroundings(target));
    if (changed)
        outline = *changed;
    return changed.has_value();
}

EdgeSurroundings EdgeFit::surroundings(const Target& target) const
{
    const ElementId id = target.edge.patch;
    EdgeSurroundings around = surroundingsOf(m_design, id, m_outlines.at(id));
    for (const auto& [patch, point] : m_pinned)
        if (patch == id)
            around.pinned.insert(point);
    for (const Target& other : m_targets) // what has its length already keeps it
        if (other.edge.patch == id)
            around.used.push_back(other.edge);
    return around;
}

std::optional<BSpline2> EdgeFit::scaled(const Target& target, double factor) const
{
    const BSpline2& outline = m_outlines.at(target.edge.patch);
    std::vector<Vec2> points = outline.points();
    const auto at = [&](int i) -> Vec2& { return points[static_cast<std::size_t>(i)]; };
    const auto pinned = [&](int i) { return m_pinned.contains({target.edge.patch, i}); };
    const int first = target.points.front(), last = target.points.back();
    if (pinned(first) && pinned(last))
        return std::nullopt;
    const Vec2 middle = target.points.size() == points.size() ? Vec2(outline.boundingBox().center())
                                                              : Vec2((at(first) + at(last)) / 2);
    const Vec2 about = pinned(first) ? at(first) : pinned(last) ? at(last) : middle;
    for (const int i : target.points)
        if (!pinned(i))
            at(i) = about + factor * (at(i) - about);
    if (BSpline2::problem(outline.degree(), outline.closed(), points, outline.knots()))
        return std::nullopt;
    return outline.withPoints(std::move(points));
}

} // namespace bolster::edits
