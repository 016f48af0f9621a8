#include "PatchMerge.h"

#include "ArcLength.h"
#include "DesignCheck.h"
#include "DividedParts.h"
#include "EditBuilder.h"
#include "NeedlessKnots.h"
#include "OutlinePlaces.h"
#include "PatchPoints.h"
#include "PlaneCurves.h"
#include "SeamEdits.h"
#include "SewnMirror.h"
#include "StretchRemap.h"
#include "TwinEdits.h"
#include "Twins.h"

#include <algorithm>
#include <cmath>

namespace bolster::edits {

namespace {

constexpr double mostEase = 0.05;

/// A patch that takes part, its outline counter-clockwise if the other one's is.
struct Half {
    ElementId id{};
    const Patch* patch = nullptr;
    BSpline2 outline;
    double from = 0, to = 0; // the stretch, unwrapped
    bool turned = false;     // the outline is walked backwards

    Half(const Design& design, const Stretch& stretch)
        : id(stretch.patch)
        , patch(design.find<Patch>(id))
    {
        if (!patch || patch->outline.empty())
            return;
        outline = patch->outline;
        from = stretch.from;
        to = unwrappedEnd(from, stretch.to, outline.domainStart(), outline.domainEnd());
    }

    void turn()
    {
        const double ends = outline.domainStart() + outline.domainEnd();
        outline = outline.reversed();
        std::tie(from, to) = std::pair(ends - to, ends - from);
        turned = true;
    }

    bool whole() const { return to - from > outline.period() * (1 - 1e-6); }
    BSpline2 rest() const { return outline.part(to, from); }
    double length() const { return ArcLength2(outline).between(from, to); }

    Vec2 at(double fraction, Match match) const
    {
        if (match == Match::Parameter)
            return outline.at(from + fraction * (to - from));
        const ArcLength2 length(outline);
        return outline.at(length.parameterAt(length.at(from) + fraction * length.between(from, to)));
    }

    /// In parameters of the outline as it was; `start` is where the rest begins now.
    OutlineArc arc(ElementId into, double start) const
    {
        const BSpline2 kept = rest();
        if (!turned)
            return {kept.domainStart(), kept.domainEnd(), into, start};
        const double ends = outline.domainStart() + outline.domainEnd();
        return {ends - kept.domainEnd(), ends - kept.domainStart(), into, start + kept.period(), true};
    }
};

/// The rigid motion that brings the second stretch onto the first one, walked the other way.
Map2 fit(const Half& a, const Half& b, Match match)
{
    constexpr int samples = 32;
    std::array<Vec2, samples + 1> p, q;
    Vec2 meanP = Vec2::Zero(), meanQ = Vec2::Zero();
    for (int k = 0; k <= samples; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const double fraction = static_cast<double>(k) / samples;
        meanP += p[i] = a.at(fraction, match);
        meanQ += q[i] = b.at(1 - fraction, match);
    }
    meanP /= samples + 1;
    meanQ /= samples + 1;
    double along = 0, across = 0;
    for (std::size_t i = 0; i <= samples; ++i) {
        const Vec2 u = q[i] - meanQ, v = p[i] - meanP;
        along += u.dot(v);
        across += u.x() * v.y() - u.y() * v.x();
    }
    Map2 map = Map2::Identity();
    map.translate(meanP).rotate(std::atan2(across, along)).translate(-meanQ);
    return map;
}

/// An open curve with an end elsewhere; a straight edge there stays straight.
BSpline2 withEnd(const BSpline2& curve, bool last, const Vec2& to)
{
    std::vector<Vec2> points = curve.points();
    const int degree = curve.degree(), count = curve.pointCount();
    const Vec2 delta = to - (last ? points.back() : points.front());
    for (int k = 0; k < std::min(degree, count - 1); ++k)
        points[static_cast<std::size_t>(last ? count - 1 - k : k)] += (1 - static_cast<double>(k) / degree) * delta;
    (last ? points.back() : points.front()) = to;
    return curve.withPoints(std::move(points));
}

bool runsCounterClockwise(const Half& half)
{
    return half.outline.signedArea() > 0;
}

std::optional<Message> problemOf(const Design& design, const Half& a, const Half& b, const Seam& seam)
{
    if (!a.patch || !b.patch || outlineProblem(a.outline) || outlineProblem(b.outline))
        return Message{QT_TRANSLATE_NOOP("Message", "A patch of the seam is missing or invalid: repair it first."),
                       {}};
    const std::string nameA = displayName(design, a.id), nameB = displayName(design, b.id);
    if (a.id == b.id)
        return Message{QT_TRANSLATE_NOOP("Message", "The seam joins %1 to itself: there is nothing to merge."),
                       {nameA}};
    if (a.whole() || b.whole())
        return Message{QT_TRANSLATE_NOOP("Message", "The seam takes up a whole outline: nothing would be left."),
                       {}};
    const bool sameWay = runsCounterClockwise(a) == runsCounterClockwise(b);
    if (a.patch->wrongSideOut != b.patch->wrongSideOut || seam.reversed != sameWay)
        return Message{QT_TRANSLATE_NOOP("Message",
                                         "The seam joins the right side of %1 to the wrong side of %2: one patch "
                                         "cannot be both."),
                       {nameA, nameB}};
    if (const double ease = seamEase(design, seam); ease > mostEase)
        return Message{
            QT_TRANSLATE_NOOP("Message", "The sides of the seam differ by %1 % in length, more than 5 %."),
            {numberText(100 * ease, 3)}};
    return std::nullopt;
}

/// Seams of two patches that follow each other on both: as one, and which they are.
struct Row {
    Seam seam;
    std::set<ElementId> ids;
};

Row rowAround(const Design& design, ElementId id)
{
    Row row{*design.find<Seam>(id), {id}};
    const auto meets = [&](ElementId patch, double end, double start) {
        const BSpline2& outline = design.find<Patch>(patch)->outline;
        return std::abs(std::remainder(end - start, outline.period())) <= 1e-9 * outline.period();
    };
    // The neighbour `next` continues the row behind its end, or before its start.
    const auto join = [&](const Seam& next) {
        Stretch &a = row.seam.a, &b = row.seam.b;
        const bool back = row.seam.reversed;
        const bool behind = meets(a.patch, a.to, next.a.from) &&
                            (back ? meets(b.patch, next.b.to, b.from) : meets(b.patch, b.to, next.b.from));
        const bool before = meets(a.patch, next.a.to, a.from) &&
                            (back ? meets(b.patch, b.to, next.b.from) : meets(b.patch, next.b.to, b.from));
        if (!behind && !before)
            return false;
        (behind ? a.to : a.from) = behind ? next.a.to : next.a.from;
        (behind != back ? b.to : b.from) = behind != back ? next.b.to : next.b.from;
        row.seam.match = Match::Length;
        return true;
    };
    for (bool grown = true; grown;) {
        grown = false;
        design.each<Seam>([&](ElementId other, Seam next) {
            if (next.a.patch == row.seam.b.patch)
                std::swap(next.a, next.b);
            const bool alike = next.a.patch == row.seam.a.patch && next.b.patch == row.seam.b.patch &&
                               next.reversed == row.seam.reversed && row.seam.a.patch != row.seam.b.patch;
            if (alike && !row.ids.contains(other) && join(next)) {
                row.ids.insert(other);
                grown = true;
            }
        });
    }
    return row;
}

/// The outline of both, in coordinates of the first one.
BSpline2 mergedOutline(const Half& a, BSpline2 restB, std::vector<double>& starts)
{
    BSpline2 restA = a.rest();
    if (restA.degree() != restB.degree()) {
        restA = raisedToCubic(restA);
        restB = raisedToCubic(restB);
    }
    const Vec2 first = (restA.points().back() + restB.points().front()) / 2;
    const Vec2 second = (restB.points().back() + restA.points().front()) / 2;
    restA = withEnd(withEnd(restA, true, first), false, second);
    restB = withEnd(withEnd(restB, false, first), true, second);
    return joined({restA, restB}, &starts);
}

/// What is drawn in the second patch goes into the first one.
/// A curve that would leave the sensible range stays where it is in the coordinates.
void moveCurves(const Design& design, ElementId from, ElementId to, const Map2& map, EditBuilder& builder)
{
    for (const auto& [id, element] : design.elements()) {
        const PatchCurve* drawn = patchCurve(*element);
        if (!drawn || drawn->patch != from)
            continue;
        const ElementPtr moved = withPlaneCurve(*element, mapped(drawn->curve, map).value_or(drawn->curve));
        builder.set(id, std::visit(
                            [&](auto value) {
                                if constexpr (std::is_base_of_v<PatchCurve, decltype(value)>)
                                    value.patch = to;
                                return makeElement(std::move(value));
                            },
                            *moved));
    }
    movePatchPoints(
        design.elements(), from,
        [&](PatchPoint& point) {
            point = {to, map * point.position};
        },
        [&](ElementId id, ElementPtr moved) { builder.set(id, std::move(moved)); });
    design.each<Cushion>([&](ElementId id, Cushion cushion) {
        if (std::erase(cushion.patches, from) == 0)
            return;
        if (std::ranges::find(cushion.patches, to) == cushion.patches.end())
            cushion.patches.push_back(to);
        builder.replace(id, std::move(cushion));
    });
    design.each<Colourway>([&](ElementId id, Colourway colourway) {
        if (std::erase_if(colourway.fabrics, [from](const auto& entry) { return entry.patch == from; }) > 0)
            builder.replace(id, std::move(colourway));
    });
}

/// What lay on the outline of a half keeps its place on the merged one, which is bent a little where both meet.
void placeOnMerged(const Design& design, const Half& half, const OutlineArc& arc, ElementId merged,
                   EditBuilder& builder)
{
    const OutlinePlaces places(half.patch->outline);
    const BSpline2& outline = builder.now().find<Patch>(merged)->outline;
    const double period = half.outline.period(), slack = 1e-9 * period;
    const auto parameter = [&](const Vec2& point) -> std::optional<double> {
        const auto t = places.parameter(point);
        if (!t)
            return std::nullopt;
        const double ahead = *t - arc.from - period * std::floor((*t - arc.from + slack) / period);
        if (ahead > arc.to - arc.from + slack)
            return std::nullopt; // on the seam, which is no outline any more
        return outline.wrapped(arc.backwards ? arc.start - ahead : arc.start + ahead);
    };
    for (const auto& [id, element] : design.elements()) {
        const PatchCurve* drawn = patchCurve(*element);
        if (!drawn || drawn->patch != half.id)
            continue;
        const ElementPtr now = builder.now().element(id);
        std::vector<Vec2> points = patchCurve(*now)->curve.points();
        for (std::size_t i = 0; i < points.size(); ++i)
            if (const auto t = parameter(drawn->curve.points()[i]))
                points[i] = outline.at(*t);
        builder.set(id, withPlaneCurve(*now, patchCurve(*now)->curve.withPoints(std::move(points))));
    }
}

Outcome mergeOne(const Design& design, ElementId seamId)
{
    const Seam* first = design.find<Seam>(seamId);
    if (!first)
        return Outcome::refused({QT_TRANSLATE_NOOP("Message", "Select the seam along which to merge."), {}});
    if (auto problem = problemOf(design, Half(design, first->a), Half(design, first->b), *first))
        return Outcome::refused(std::move(*problem));
    const auto [seam, row] = rowAround(design, seamId);
    Half a(design, seam.a), b(design, seam.b);
    if (auto problem = problemOf(design, a, b, seam))
        return Outcome::refused(std::move(*problem));
    if (runsCounterClockwise(a) != runsCounterClockwise(b))
        b.turn();

    const Map2 map = fit(a, b, seam.match);
    std::vector<double> starts;
    Patch merged = *a.patch;
    if (const auto restB = mapped(b.rest(), map))
        merged.outline = mergedOutline(a, *restB, starts);
    if (starts.empty() || outlineProblem(merged.outline))
        return Outcome::refused(
            {QT_TRANSLATE_NOOP("Message", "Merged, %1 and %2 would overlap or cross: the seam stays."),
             {displayName(design, a.id), displayName(design, b.id)}});
    for (const double joint : starts)
        merged.outline = withoutNeedlessKnots(std::move(merged.outline), joint);

    if (const std::string& other = b.patch->note; !other.empty() && other != merged.note)
        merged.note.append(merged.note.empty() ? "" : "\n").append(other);

    Outcome outcome;
    EditBuilder builder(design);
    builder.replace(a.id, std::move(merged));
    const OutlineArcs arcs = {{a.id, {a.arc(a.id, starts[0])}}, {b.id, {b.arc(a.id, starts[1])}}};
    remapStretches(design, arcs, row, builder, outcome.dropped);
    moveCurves(design, b.id, a.id, map, builder);
    for (const Half* half : {&a, &b})
        placeOnMerged(design, *half, arcs.at(half->id).front(), a.id, builder);
    for (const ElementId id : row)
        builder.remove(id);
    builder.remove(b.id);
    joinDivided(design, a.id, b.id, starts, builder);
    outcome.edit = builder.result(
        {QT_TRANSLATE_NOOP("Message", "Merge %1 and %2"), {displayName(design, a.id), displayName(design, b.id)}});
    return outcome;
}

} // namespace

Outcome mergePatches(const Design& design, ElementId seamId)
{
    Outcome outcome = mergeOne(design, seamId);
    const Seam* seam = design.find<Seam>(seamId);
    if (outcome.edit.empty() || twinOf(design, seam->a.patch) == noElement)
        return outcome;
    Design half = design.with(outcome.edit);
    const SewnMirror mirror(design, twinPairs(design));
    const auto [other, swapped] = mirror.counterpart(*seam);
    const bool both = other != noElement && other != seamId && mirror.twin(seam->b.patch) != noElement &&
                      mirror.twin(seam->b.patch) != seam->a.patch;
    if (!both) { // what it becomes is no mirror image of its twin any more
        half = half.with(unlinkTwins(half, std::array{seam->a.patch}));
        outcome.edit = editBetween(design, half, std::move(outcome.edit.verb));
        return outcome;
    }
    if (swapped)
        half = half.with(swapSeamSides(half, std::array{other}));
    Outcome there = mergeOne(half, other);
    if (there.edit.empty())
        return there;
    outcome.edit = editBetween(design, half.with(there.edit), std::move(outcome.edit.verb));
    outcome.dropped.insert(outcome.dropped.end(), there.dropped.begin(), there.dropped.end());
    return outcome;
}

} // namespace bolster::edits
