#include "FixationEdits.h"

#include "ArcLength.h"
#include "EditHelpers.h"
#include "HandleEdits.h"
#include "PatternLocator.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bolster::edits {

namespace {

constexpr double shortestFixed = 0.1; // mm, of what can be fixed
constexpr int waySteps = 32;          // samples along a stretch that tell where it lies

using WayRange = std::pair<double, double>;

const BSpline2* outlineUnder(const Design& design, const Stretch& stretch)
{
    const auto* patch = design.find<Patch>(stretch.patch);
    return patch && !patch->outline.empty() ? &patch->outline : nullptr; // alive as long as the design
}

const BSpline3* fixationCurveOf(const Design& design, ElementId id)
{
    const auto* found = design.find<FixationCurve>(id);
    return found && !found->curve.empty() ? &found->curve : nullptr;
}

double extent(const Stretch& stretch, const BSpline2& outline)
{
    return unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd()) - stretch.from;
}

/// Whether two stretches of one outline have more than end points in common.
bool overlapOn(const Stretch& a, const Stretch& b, const BSpline2& outline)
{
    const double period = outline.period(), offset = b.from - a.from, slack = 1e-9 * period;
    double ahead = offset - period * std::floor(offset / period); // of b's start, seen from a's
    if (period - ahead < slack)
        ahead = 0;
    return ahead < extent(a, outline) - slack || ahead + extent(b, outline) > period + slack;
}

bool same(const Stretch& a, const Stretch& b, const BSpline2& outline)
{
    const double slack = 1e-9 * outline.period();
    const auto apart = [&](double s, double t) {
        return std::abs(std::remainder(s - t, outline.period())) > slack;
    };
    return a.patch == b.patch && !apart(a.from, b.from) && !apart(a.to, b.to);
}

/// The fixation of just this stretch; noElement when there is none.
ElementId fixationOf(const Design& design, const Stretch& stretch, const BSpline2& outline)
{
    ElementId result = noElement;
    design.each<FixationSeam>([&](ElementId id, const FixationSeam& seam) {
        if (same(seam.stretch, stretch, outline))
            result = id;
    });
    return result;
}

/// Where evenly spaced points of a stretch lie on the surface; nothing when it lacks the patch.
std::vector<Vec3> wayOf(const SurfaceMesh* surface, const Stretch& stretch, const BSpline2& outline)
{
    if (!surface || !surface->topology)
        return {};
    const auto& patches = surface->topology->patches;
    const auto range = std::ranges::find(patches, stretch.patch, &SurfaceTopology::PatchRange::patch);
    if (range == patches.end() || range->triangleCount == 0)
        return {};
    const PatternLocator locator(*surface->topology, *range);
    const ArcLength2 length(outline);
    const double start = length.at(stretch.from);
    const double whole = length.at(stretch.from + extent(stretch, outline)) - start;
    std::vector<Vec3> way;
    for (int k = 0; k <= waySteps; ++k) {
        const PatternPlace at = locator.locate(outline.at(length.parameterAt(start + whole * k / waySteps)));
        way.push_back(Vec3::Zero());
        for (int c = 0; c < 3; ++c)
            way.back() += at.weights[c] * surface->positions[at.corners[static_cast<std::size_t>(c)]];
    }
    return way;
}

/// How far the way would have to go: its mean square distance from where it would be fixed.
double farness(const std::vector<Vec3>& way, const BSpline3& curve, const WayRange& range, bool reversed)
{
    const ArcLength3 length(curve);
    const double start = length.at(range.first);
    const double end =
        length.at(curve.closed() ? unwrappedEnd(range.first, range.second, curve.domainStart(), curve.domainEnd())
                                 : range.second);
    double sum = 0;
    for (std::size_t k = 0; k < way.size(); ++k) {
        const double share = static_cast<double>(k) / waySteps;
        const double s = start + (end - start) * (reversed ? 1 - share : share);
        sum += (curve.at(length.parameterAt(s)) - way[k]).squaredNorm();
    }
    return sum;
}

struct Part {
    std::optional<WayRange> range;
    bool reversed = false;
};

/// The part of a curve, or with `range` of that part, and the direction in which the way is nearest to it.
Part nearestPart(const std::vector<Vec3>& way, const BSpline3& curve, std::optional<WayRange> range)
{
    if (way.empty())
        return {range, false};
    std::vector<Part> candidates;
    if (curve.closed() && !range) {
        const double from = curve.wrapped(curve.closest(way.front()).parameter);
        const double to = curve.wrapped(curve.closest(way.back()).parameter);
        candidates = {{WayRange(from, to), false}, {WayRange(to, from), true}};
    } else {
        candidates = {{range, false}, {range, true}};
    }
    const auto far = [&](const Part& part) {
        return farness(way, curve, part.range.value_or(WayRange(curve.domainStart(), curve.domainEnd())),
                       part.reversed);
    };
    return far(candidates[1]) < far(candidates[0]) ? candidates[1] : candidates[0];
}

/// Where fixations of other stretches hold a point of an outline in space.
std::optional<Vec3> heldAt(const Design& design, const Stretch& but, double parameter, const BSpline2& outline)
{
    std::optional<Vec3> held;
    design.each<FixationSeam>([&](ElementId, const FixationSeam& seam) {
        const BSpline3* curve = fixationCurveOf(design, seam.curve);
        if (!curve || seam.stretch.patch != but.patch || same(seam.stretch, but, outline))
            return;
        const auto [start, end] = seam.curveRange.value_or(WayRange(curve->domainStart(), curve->domainEnd()));
        const auto isHere = [&](double place) {
            return std::abs(std::remainder(place - parameter, outline.period())) < 1e-9 * outline.period();
        };
        if (isHere(seam.stretch.from))
            held = curve->at(seam.reversed ? end : start);
        else if (isHere(seam.stretch.to))
            held = curve->at(seam.reversed ? start : end);
    });
    return held;
}

/// Corners that are held already tell the direction better than a cover that hangs somewhere else.
Part fromHeldCorners(const Design& design, const Stretch& stretch, const BSpline2& outline, const BSpline3& curve,
                     Part part)
{
    if (part.range || curve.closed())
        return part;
    const std::optional<Vec3> first = heldAt(design, stretch, stretch.from, outline);
    const std::optional<Vec3> last = heldAt(design, stretch, stretch.to, outline);
    const auto gap = [&](const Vec3& start, const Vec3& end) {
        return (first ? (start - *first).norm() : 0) + (last ? (end - *last).norm() : 0);
    };
    const Vec3 start = curve.at(curve.domainStart()), end = curve.at(curve.domainEnd());
    const double forwards = gap(start, end), backwards = gap(end, start);
    if (std::abs(forwards - backwards) > 1e-3 * (end - start).norm())
        part.reversed = backwards < forwards;
    return part;
}

/// The design with the stretch fixed to a part of the curve, or the same one when that cannot be.
Design attached(const Design& design, const Stretch& stretch, ElementId curve, const Part& part)
{
    const BSpline2* outline = outlineUnder(design, stretch);
    if (!outline || fixationProblem(design, stretch))
        return design;
    FixationSeam seam;
    seam.stretch = stretch;
    const ElementId before = fixationOf(design, stretch, *outline);
    if (before != noElement)
        seam = *design.find<FixationSeam>(before);
    seam.curve = curve;
    seam.curveRange = part.range;
    seam.reversed = part.reversed;
    seam.match = Match::Length;
    const ElementPtr element = makeElement(std::move(seam));
    return design.with(before == noElement ? addElement(design, element)
                                           : replaceElement(design, before, element, {}));
}

/// Positions in which things lie along something, as an order.
std::vector<std::size_t> sorted(const std::vector<double>& places)
{
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return places[i]; });
    return order;
}

/// How far along the way its nearest sample is.
double shareNear(const std::vector<Vec3>& way, const Vec3& point)
{
    const auto nearest =
        std::ranges::min_element(way, {}, [&](const Vec3& p) { return (p - point).squaredNorm(); });
    return static_cast<double>(nearest - way.begin()) / waySteps;
}

/// A place along a closed curve, mm; at its nearest corner if that is closer than `reach`: corners of the cover
/// belong on those of what it is fixed to.
double atCorner(const BSpline3& curve, const ArcLength3& length, double place, double reach)
{
    double best = place;
    for (const double corner : curve.corners()) {
        const double way = std::remainder(length.at(corner) - place, length.total());
        if (std::abs(way) < reach) {
            reach = std::abs(way);
            best = place + way;
        }
    }
    return best;
}

Message attachVerb(const Design& design, const Stretch& stretch, ElementId curve)
{
    return {QT_TRANSLATE_NOOP("Message", "Attach %1 to %2"),
            {displayName(design, stretch.patch), displayName(design, curve)}};
}

} // namespace

std::optional<Message> fixationProblem(const Design& design, const Stretch& stretch)
{
    const BSpline2* outline = outlineUnder(design, stretch);
    if (!outline || !std::isfinite(stretch.from) || !std::isfinite(stretch.to))
        return Message{QT_TRANSLATE_NOOP("Message", "There is no such stretch of an outline."), {}};
    const ArcLength2 length(*outline);
    if (!(length.between(stretch.from, stretch.from + extent(stretch, *outline)) >= shortestFixed))
        return Message{QT_TRANSLATE_NOOP("Message", "The stretch has no length."), {}};
    std::optional<Message> problem;
    design.each<FixationSeam>([&](ElementId, const FixationSeam& seam) {
        if (!problem && seam.hasCurve() && seam.stretch.patch == stretch.patch &&
            !same(seam.stretch, stretch, *outline) && overlapOn(seam.stretch, stretch, *outline))
            problem = Message{
                QT_TRANSLATE_NOOP("Message", "A part of this stretch is fixed to %1 already: remove that fixation "
                                             "or choose another stretch."),
                {displayName(design, seam.curve)}};
    });
    return problem;
}

Edit addFixationFromSurface(const Design& design, const SurfaceMesh& surface, const Stretch& stretch,
                            const std::string& name)
{
    const BSpline2* outline = outlineUnder(design, stretch);
    if (!outline || !surface.topology || fixationProblem(design, stretch))
        return {};
    const double all = extent(stretch, *outline), slack = 1e-9 * outline->period();
    const bool whole = all > outline->period() - slack;
    std::optional<BSpline3> curve =
        liftedCurve(surface, stretch.patch, whole ? *outline : outline->part(stretch.from, stretch.from + all));
    if (!curve)
        return {};
    Part part;
    if (whole && std::abs(stretch.from - outline->domainStart()) > slack)
        part.range = WayRange(curve->wrapped(stretch.from), curve->wrapped(stretch.from));
    FixationCurve fixation{name, std::move(*curve)};
    const Edit added = addElement(design, makeElement(std::move(fixation)));
    const ElementId id = added.changes.front().id;
    const Design fixed = attached(design.with(added), stretch, id, part);
    Edit edit = editBetween(design, fixed, {QT_TRANSLATE_NOOP("Message", "Create fixation curve %1"), {name}});
    // The cover may be stretched unevenly along the curve: equal parameters keep it where it is.
    for (Change& change : edit.changes)
        if (const auto* seam = std::get_if<FixationSeam>(change.after.get())) {
            FixationSeam matched = *seam;
            matched.match = Match::Parameter;
            change.after = makeElement(std::move(matched));
        }
    std::stable_partition(edit.changes.begin(), edit.changes.end(),
                          [id](const Change& change) { return change.id == id; });
    return edit;
}

Edit attachStretch(const Design& design, const Stretch& stretch, ElementId curve, const SurfaceMesh* surface)
{
    return attachStretches(design, std::span(&stretch, 1), curve, surface);
}

Edit attachStretches(const Design& design, std::span<const Stretch> stretches, ElementId curve,
                     const SurfaceMesh* surface)
{
    const BSpline3* target = fixationCurveOf(design, curve);
    if (!target || stretches.empty())
        return {};
    std::vector<std::vector<Vec3>> ways;
    std::vector<double> lengths, places;
    for (const Stretch& stretch : stretches) {
        const BSpline2* outline = outlineUnder(design, stretch);
        if (!outline || fixationProblem(design, stretch))
            return {};
        lengths.push_back(ArcLength2(*outline).between(stretch.from, stretch.from + extent(stretch, *outline)));
        ways.push_back(wayOf(surface, stretch, *outline));
        places.push_back(ways.back().empty() ? static_cast<double>(places.size())
                                             : target->closest(ways.back()[waySteps / 2]).parameter);
    }
    if (stretches.size() == 1)
        return editBetween(design,
                           attached(design, stretches[0], curve,
                                    fromHeldCorners(design, stretches[0], *outlineUnder(design, stretches[0]),
                                                    *target, nearestPart(ways[0], *target, {}))),
                           attachVerb(design, stretches[0], curve));

    const ArcLength3 length(*target);
    const double whole = std::accumulate(lengths.begin(), lengths.end(), 0.0), scale = length.total() / whole;
    const std::vector<std::size_t> order = sorted(places);
    double at = 0;
    if (target->closed() && !ways[order[0]].empty())
        at = atCorner(*target, length, length.at(places[order[0]]) - 0.5 * scale * lengths[order[0]],
                      0.5 * scale * std::ranges::min(lengths));
    Design now = design;
    for (const std::size_t i : order) {
        const double end = at + scale * lengths[i];
        const auto parameter = [&](double s) { return target->wrapped(length.parameterAt(s)); };
        const bool last = !target->closed() && i == order.back();
        const WayRange range(parameter(at), last ? target->domainEnd() : parameter(end));
        if (fixationProblem(now, stretches[i])) // they overlap each other
            return {};
        now = attached(now, stretches[i], curve, nearestPart(ways[i], *target, range));
        at = end;
    }
    return editBetween(design, now,
                       {QT_TRANSLATE_NOOP("Message", "Attach %1 stretches to %2"),
                        {std::to_string(stretches.size()), displayName(design, curve)}});
}

Edit attachToCurves(const Design& design, const Stretch& stretch, std::span<const ElementId> curves,
                    const SurfaceMesh* surface)
{
    if (curves.size() == 1)
        return attachStretch(design, stretch, curves[0], surface);
    const BSpline2* outline = outlineUnder(design, stretch);
    if (!outline || curves.empty() || fixationProblem(design, stretch))
        return {};
    const std::vector<Vec3> way = wayOf(surface, stretch, *outline);
    std::vector<double> lengths, places;
    for (const ElementId id : curves) {
        const BSpline3* curve = fixationCurveOf(design, id);
        if (!curve)
            return {};
        const ArcLength3 length(*curve);
        lengths.push_back(length.total());
        places.push_back(way.empty() ? static_cast<double>(places.size())
                                     : shareNear(way, curve->at(length.parameterAt(0.5 * length.total()))));
    }
    const ArcLength2 length(*outline);
    double at = length.at(stretch.from);
    const double end = length.at(stretch.from + extent(stretch, *outline));
    const double scale = (end - at) / std::accumulate(lengths.begin(), lengths.end(), 0.0);
    Design now = design;
    if (const ElementId before = fixationOf(design, stretch, *outline); before != noElement)
        now = now.with(removeElements(now, std::span(&before, 1))); // the pieces take its place
    const std::vector<std::size_t> order = sorted(places);
    double from = stretch.from;
    for (const std::size_t i : order) {
        at += scale * lengths[i];
        const double to = i == order.back() ? stretch.to : outline->wrapped(length.parameterAt(at));
        const Stretch piece{stretch.patch, from, to};
        now = attached(now, piece, curves[i],
                       nearestPart(wayOf(surface, piece, *outline), *fixationCurveOf(now, curves[i]), {}));
        from = to;
    }
    return editBetween(design, now,
                       {QT_TRANSLATE_NOOP("Message", "Attach %1 to %2 curves"),
                        {displayName(design, stretch.patch), std::to_string(curves.size())}});
}

} // namespace bolster::edits
