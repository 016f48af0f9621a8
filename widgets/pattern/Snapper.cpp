#include "Snapper.h"

#include "PatternGrid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

/// A rail near a place.
struct RailTangent {
    Vec2 point;
    Vec2 along; ///< unit
};

namespace {

// Pixels.
constexpr double snapPointReach = 9;
constexpr double lineReach = 6;
constexpr double gridReach = 4;
constexpr double farthestAligned = 700; // what is farther away than a view is wide nobody means

using Tangent = RailTangent;

Tangent onLine(const Vec2& origin, const Vec2& along, const Vec2& at)
{
    return {origin + along.dot(at - origin) * along, along};
}

/// Where the tangents cross, if they do.
std::optional<Vec2> crossing(const Tangent& a, const Tangent& b)
{
    const double cross = a.along.x() * b.along.y() - a.along.y() * b.along.x();
    if (std::abs(cross) < 0.05)
        return std::nullopt;
    const Vec2 way = b.point - a.point;
    return a.point + (way.x() * b.along.y() - way.y() * b.along.x()) / cross * a.along;
}

Vec2 direction(double degrees)
{
    const double radians = degrees * std::numbers::pi / 180;
    return {std::cos(radians), std::sin(radians)};
}

/// Corners and other points on an outline: what can be seen without selecting it.
template <class F>
void eachCorner(const PatternPatch& patch, F function)
{
    for (std::size_t i = 0; i < patch.points.size(); ++i)
        if (patch.corners[i])
            function(static_cast<int>(i), patch.points[i]);
}

} // namespace

/// A line or curve on which the point may come to lie.
struct Snapper::Rail {
    SnapHint hint;
    double rank; ///< of two at the same distance the lower one is meant
    std::function<RailTangent(const Vec2&)> nearest;

    /// Where both meet near `at`: by Newton's method, exact at once for two lines.
    std::optional<Vec2> meet(const Rail& other, Vec2 at, double tolerance) const
    {
        for (int i = 0; i < 12; ++i) {
            const std::optional<Vec2> next = crossing(nearest(at), other.nearest(at));
            if (!next || !next->allFinite())
                return std::nullopt;
            const bool done = (*next - at).norm() < tolerance;
            at = *next;
            if (done)
                return at;
        }
        return std::nullopt;
    }
};

Snapper::Snapper(const PatternScene& scene, const PatternTransform& transform, const SnapSettings& settings)
    : m_scene(scene)
    , m_transform(transform)
    , m_settings(settings)
    , m_reach(transform.millimetres(snapPointReach))
    , m_lineReach(transform.millimetres(lineReach))
{}

Snapped Snapper::snap(const SnapQuery& query) const
{
    if (!m_settings.on)
        return {query.at, {}};
    if (std::optional<Snapped> point = toPoint(query))
        return *point;
    const std::vector<Rail> found = rails(query);
    if (found.empty())
        return {query.at, {}};
    const Rail& first = found.front();
    Snapped best{first.nearest(query.at).point, {first.hint}};
    for (std::size_t i = 1; i < found.size(); ++i) {
        const auto both = first.meet(found[i], query.at, 1e-6 * m_reach);
        if (!both || (*both - query.at).norm() > m_reach)
            continue;
        best = {*both, {first.hint, found[i].hint}};
        break;
    }
    for (SnapHint& hint : best.hints)
        hint.to = best.point;
    return best;
}

std::optional<Snapped> Snapper::toPoint(const SnapQuery& query) const
{
    std::optional<Snapped> best;
    double nearest = m_reach;
    const auto offer = [&](const Vec2& point, SnapHint::Kind kind, double handicap) {
        const double distance = (point - query.at).norm() + handicap;
        if (distance >= nearest)
            return;
        nearest = distance;
        best = Snapped{point, {{kind, point, point}}};
    };
    for (const Vec2& point : query.own)
        offer(point, SnapHint::Kind::Point, 0);
    for (const auto& [id, patch] : m_scene.patches()) {
        if (query.ignored.contains(id) || patch.points.empty())
            continue;
        for (std::size_t i = 0; i < patch.points.size(); ++i)
            if (!query.ignoredPoints.contains({id, static_cast<int>(i)}))
                // Off the outline, a control point is seen only when its patch is selected.
                offer(patch.points[i], SnapHint::Kind::Point, patch.corners[i] ? 0 : 0.4 * m_reach);
        if (patch.box.exteriorDistance(query.at) <= m_reach)
            for (const PatternEdge& edge : patch.edges)
                if (edge.ends && query.ignoredPoints.empty())
                    offer(toLayout(patch.patch(), edge.middle), SnapHint::Kind::Midpoint, 0.2 * m_reach);
    }
    return best;
}

std::vector<Snapper::Rail> Snapper::rails(const SnapQuery& query) const
{
    std::vector<Rail> all;
    addOutlines(query, all);
    addGuides(query, all);
    addDirections(query, all);
    addAlignments(query, all);
    addLengths(query, all);
    addGrid(query, all);
    std::vector<Rail> near;
    for (Rail& rail : all) {
        const double distance = (rail.nearest(query.at).point - query.at).norm();
        const bool grid = rail.hint.kind == SnapHint::Kind::Grid;
        if (!(distance <= (grid ? m_transform.millimetres(gridReach) : m_lineReach)))
            continue;
        rail.rank += distance / m_lineReach;
        near.push_back(std::move(rail));
    }
    std::ranges::stable_sort(near, {}, &Rail::rank);
    return near;
}

void Snapper::addOutlines(const SnapQuery& query, std::vector<Rail>& rails) const
{
    for (const auto& [id, patch] : m_scene.patches()) {
        const BSpline2& outline = patch.patch().outline;
        const bool moves =
            query.ignored.contains(id) ||
            std::ranges::any_of(query.ignoredPoints, [id = id](const auto& p) { return p.first == id; });
        if (moves || outline.empty() || patch.box.exteriorDistance(query.at) > m_lineReach)
            continue;
        const auto nearest = [&patch = patch.patch()](const Vec2& at) {
            const BSpline2::Closest closest = patch.outline.closest(fromLayout(patch, at));
            const Vec2 on = toLayout(patch, closest.point);
            const Vec2 along = toLayout(patch, closest.point + patch.outline.derivative(closest.parameter)) - on;
            return Tangent{on, along.normalized()};
        };
        rails.push_back({{SnapHint::Kind::Outline, nearest(query.at).point}, 0, nearest});
    }
}

void Snapper::addDirections(const SnapQuery& query, std::vector<Rail>& rails) const
{
    if (!query.from || (query.at - *query.from).norm() < m_reach)
        return;
    const Vec2 from = *query.from;
    const Vec2 way = query.at - from;
    const double degrees = std::atan2(way.y(), way.x()) * 180 / std::numbers::pi;
    const double round = 45 * std::round(degrees / 45);
    const auto add = [&](SnapHint::Kind kind, const Vec2& along, double value, double rank) {
        rails.push_back(
            {{kind, from, from, value}, rank, [from, along](const Vec2& at) { return onLine(from, along, at); }});
    };
    add(SnapHint::Kind::Direction, direction(round), round, 0.1);
    if (!query.before || (from - *query.before).norm() < 1e-9)
        return;
    const Vec2 last = (from - *query.before).normalized();
    add(SnapHint::Kind::Perpendicular, {-last.y(), last.x()}, 90, 0.15);
}

void Snapper::addAlignments(const SnapQuery& query, std::vector<Rail>& rails) const
{
    std::array<std::optional<Vec2>, 2> best; // that share x, and y
    const auto offer = [&](const Vec2& point) {
        if ((query.from && (point - *query.from).norm() < 1e-9) ||
            (point - query.at).norm() > m_transform.millimetres(farthestAligned))
            return;
        for (int axis = 0; axis < 2; ++axis) {
            const double off = std::abs(point[axis] - query.at[axis]);
            std::optional<Vec2>& now = best[static_cast<std::size_t>(axis)];
            if (off > m_lineReach || (point - query.at).norm() < m_reach)
                continue;
            const double before = now ? std::abs((*now)[axis] - query.at[axis]) : m_lineReach;
            const bool nearer =
                now && std::abs(off - before) < 1e-9 && (point - query.at).norm() < (*now - query.at).norm();
            if (!now || off < before - 1e-9 || nearer)
                now = point;
        }
    };
    for (const Vec2& point : query.own)
        offer(point);
    for (const auto& [id, patch] : m_scene.patches())
        if (!query.ignored.contains(id))
            eachCorner(patch, [&, id = id](int i, const Vec2& point) {
                if (!query.ignoredPoints.contains({id, i}))
                    offer(point);
            });
    for (int axis = 0; axis < 2; ++axis)
        if (const std::optional<Vec2>& with = best[static_cast<std::size_t>(axis)])
            rails.push_back({{SnapHint::Kind::Alignment, *with}, 0.3, [with = *with, axis](const Vec2& at) {
                                 return onLine(with, axis == 0 ? Vec2::UnitY() : Vec2::UnitX(), at);
                             }});
}

void Snapper::addLengths(const SnapQuery& query, std::vector<Rail>& rails) const
{
    std::vector<Vec2> starts = query.lengthsFrom;
    if (query.from)
        starts.push_back(*query.from);
    for (const Vec2& from : starts) {
        const double best = lengthNear(query, (query.at - from).norm());
        if (best == 0)
            continue;
        const auto nearest = [from, best](const Vec2& at) {
            const Vec2 out = (at - from).norm() > 0 ? Vec2((at - from).normalized()) : Vec2::UnitX();
            return Tangent{from + best * out, {-out.y(), out.x()}};
        };
        rails.push_back({{SnapHint::Kind::EqualLength, from, from, best}, 0.4, nearest});
    }
    for (int axis = 0; query.boxFrom && axis < 2; ++axis) {
        const double way = query.at[axis] - (*query.boxFrom)[axis];
        const double best = lengthNear(query, std::abs(way));
        if (best == 0)
            continue;
        const double place = (*query.boxFrom)[axis] + std::copysign(best, way);
        const auto nearest = [axis, place](const Vec2& at) {
            return axis == 0 ? Tangent{{place, at.y()}, Vec2::UnitY()} : Tangent{{at.x(), place}, Vec2::UnitX()};
        };
        Vec2 from = query.at;
        from[axis] = (*query.boxFrom)[axis];
        rails.push_back({{SnapHint::Kind::EqualLength, from, from, best}, 0.4, nearest});
    }
}

/// The length of an edge that is nearest to this one; 0 without any. Edges that end at what moves do not count.
double Snapper::lengthNear(const SnapQuery& query, double length) const
{
    double best = 0;
    const auto offer = [&](double other) {
        if (other > m_reach && std::abs(other - length) < std::abs(best - length))
            best = other;
    };
    for (std::size_t i = 1; i < query.own.size(); ++i)
        offer((query.own[i] - query.own[i - 1]).norm());
    for (const auto& [id, patch] : m_scene.patches()) {
        if (query.ignored.contains(id))
            continue;
        const BSpline2& outline = patch.patch().outline;
        const auto moves = [&, id = id](double parameter) {
            return query.ignoredPoints.contains({id, outline.pointAt(outline.wrapped(parameter))});
        };
        for (const PatternEdge& edge : patch.edges)
            if (edge.ends && (query.ignoredPoints.empty() || (!moves(edge.from) && !moves(edge.to))))
                offer(edge.length);
    }
    return best;
}

void Snapper::addGuides(const SnapQuery& query, std::vector<Rail>& rails) const
{
    for (const double x : m_settings.guides.x)
        rails.push_back({{SnapHint::Kind::Guide, {x, query.at.y()}}, 0, [x](const Vec2& at) {
                             return onLine({x, 0}, Vec2::UnitY(), at);
                         }});
    for (const double y : m_settings.guides.y)
        rails.push_back({{SnapHint::Kind::Guide, {query.at.x(), y}}, 0, [y](const Vec2& at) {
                             return onLine({0, y}, Vec2::UnitX(), at);
                         }});
}

void Snapper::addGrid(const SnapQuery& query, std::vector<Rail>& rails) const
{
    if (!m_settings.grid)
        return;
    const double step = gridStep(m_transform.scale());
    const Vec2 node = step * Vec2(std::round(query.at.x() / step), std::round(query.at.y() / step));
    const bool coarse = m_transform.scale() * step > 4 * gridReach; // else it would catch everywhere
    if (!coarse)
        return;
    for (const Vec2& along : {Vec2(0, 1), Vec2(1, 0)})
        rails.push_back(
            {{SnapHint::Kind::Grid, node}, 0.8, [node, along](const Vec2& at) { return onLine(node, along, at); }});
}

Snapped Snapper::snapMove(std::span<const Vec2> points, const Vec2& delta, const std::set<ElementId>& ignored) const
{
    if (!m_settings.on)
        return {delta, {}};
    std::optional<Snapped> onto;
    double nearest = m_reach;
    std::array<std::optional<Snapped>, 2> aligned; // x and y, each with its own shift
    std::array<double, 2> least = {m_lineReach, m_lineReach};
    const auto offerLine = [&](int axis, double place, const Vec2& point, const SnapHint& hint) {
        const double off = place - point[axis] - delta[axis];
        if (std::abs(off) >= least[static_cast<std::size_t>(axis)])
            return;
        least[static_cast<std::size_t>(axis)] = std::abs(off);
        Vec2 way = delta;
        way[axis] += off;
        aligned[static_cast<std::size_t>(axis)] = Snapped{way, {hint}};
        aligned[static_cast<std::size_t>(axis)]->hints[0].to = point; // still without the way
    };
    for (const Vec2& point : points) {
        for (const auto& [id, patch] : m_scene.patches()) {
            if (ignored.contains(id))
                continue;
            eachCorner(patch, [&](int, const Vec2& target) {
                if (const double distance = (target - point - delta).norm(); distance < nearest) {
                    nearest = distance;
                    onto = Snapped{target - point, {{SnapHint::Kind::Point, target, target}}};
                }
                for (int axis = 0; axis < 2; ++axis)
                    offerLine(axis, target[axis], point, {SnapHint::Kind::Alignment, target});
            });
        }
        for (const double x : m_settings.guides.x)
            offerLine(0, x, point, {SnapHint::Kind::Guide, {x, point.y() + delta.y()}});
        for (const double y : m_settings.guides.y)
            offerLine(1, y, point, {SnapHint::Kind::Guide, {point.x() + delta.x(), y}});
    }
    if (onto)
        return *onto;
    Snapped result{delta, {}};
    for (int axis = 0; axis < 2; ++axis)
        if (const auto& found = aligned[static_cast<std::size_t>(axis)]) {
            result.point[axis] = found->point[axis];
            result.hints.push_back(found->hints.front());
        }
    for (SnapHint& hint : result.hints)
        hint.to += result.point;
    return result;
}

} // namespace bolster
