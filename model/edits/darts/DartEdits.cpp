#include "DartEdits.h"

#include "ArcLength.h"
#include "DartClosing.h"
#include "DartSewing.h"
#include "DesignCheck.h"
#include "EditBuilder.h"
#include "FoldedSeam.h"
#include "OutlineCrossings.h"
#include "PlaneCurves.h"
#include "StraightCorner.h"
#include "StretchRemap.h"
#include "Twins.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace bolster::edits {

namespace {

constexpr double narrowest = 1; // mm: of a mouth
constexpr double shortest = 5;  // mm: of a leg
constexpr double sameSpot = 1e-6;
constexpr double nearlySameSpot = 1e-3; // mm

Edit refused(Message* problem, Message why)
{
    if (problem)
        *problem = std::move(why);
    return {};
}

Message tipProblem()
{
    return {
        QT_TRANSLATE_NOOP("Message", "The tip of a dart must lie inside its patch, at least 5 mm from its mouth."),
        {}};
}

Message legsProblem(const Design& design, ElementId patch)
{
    return {
        QT_TRANSLATE_NOOP("Message", "The legs of the dart would cross the outline of %1: put its tip elsewhere."),
        {displayName(design, patch)}};
}

/// From one end of the mouth to the other the shorter way, unwrapped.
struct Mouth {
    double from = 0;
    double to = 0;
};

Mouth shorterWay(const BSpline2& outline, double a, double b)
{
    const ArcLength2 length(outline);
    const double period = outline.period();
    a = outline.wrapped(a);
    b = outline.wrapped(b);
    const double end = b > a ? b : b + period;
    if (2 * length.between(a, end) <= length.total())
        return {a, end};
    return {b, a > b ? a : a + period};
}

/// The outline with straight lines through `inner` in place of a part, which keeps its parameters; `corners`
/// becomes those of these points.
std::optional<BSpline2> withLines(const BSpline2& outline, const Mouth& part, const std::vector<Vec2>& inner,
                                  std::vector<double>& corners)
{
    const BSpline2 kept = outline.part(outline.wrapped(part.to), outline.wrapped(part.from));
    std::vector<Vec2> points{kept.points().back()};
    points.insert(points.end(), inner.begin(), inner.end());
    points.push_back(kept.points().front());
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += (points[i] - points[i - 1]).norm();
    if (!(length > 0))
        return std::nullopt;
    const double speed = length / (part.to - part.from);
    std::vector<double> starts;
    const BSpline2 whole = joined({kept, polyline(points, outline.degree(), 0, speed)}, &starts);
    const double start = inFirstTurn(outline, part.to);
    const BSpline2 result = beginningAt(whole, start);
    double at = starts[1] + start;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        at += (points[i] - points[i - 1]).norm() / speed;
        corners.push_back(at);
    }
    return outlineProblem(result) ? std::nullopt : std::optional(result);
}

/// What lies on this part of the outline stays there, by parameters of the domain that the outline has now; what
/// lies elsewhere goes.
void keepPlaces(const Design& design, const Mouth& kept, ElementId patch, const std::set<ElementId>& except,
                EditBuilder& builder)
{
    std::vector<ElementId> dropped;
    remapStretches(design, {{patch, {{kept.from, kept.to, patch, kept.from}}}}, except, builder, dropped);
}

} // namespace

DartShape dartBetween(const Design& design, ElementId patch, double a, double b)
{
    const BSpline2& outline = design.find<Patch>(patch)->outline;
    const Mouth mouth = shorterWay(outline, a, b);
    return {patch, outline.wrapped(mouth.from), outline.wrapped(mouth.to)};
}

std::optional<double> mouthEnd(const BSpline2& outline, double from, double width, bool ahead)
{
    const ArcLength2 length(outline);
    const Vec2 start = outline.at(outline.wrapped(from));
    double way = width; // along the outline
    for (int step = 0; step < 50 && way > 0 && 2 * way <= length.total(); ++step) {
        const double end = outline.wrapped(length.parameterAt(length.at(from) + (ahead ? way : -way)));
        const double across = (outline.at(end) - start).norm();
        if (std::abs(across - width) < 1e-9 * width)
            return end;
        way *= across > 0 ? width / across : 2;
    }
    return std::nullopt;
}

DartAxis dartAxis(const BSpline2& outline, const DartShape& dart)
{
    const Vec2 a = outline.at(outline.wrapped(dart.from)), b = outline.at(outline.wrapped(dart.to));
    const Vec2 along = b - a;
    const Vec2 inwards = outline.signedArea() < 0 ? Vec2(along.y(), -along.x()) : Vec2(-along.y(), along.x());
    return {(a + b) / 2, along.norm() > 0 ? Vec2(inwards.normalized()) : Vec2(0, 1), along.norm()};
}

namespace {

/// A dart of which something lies within the mouth of another one.
bool hasDartWithin(const Design& design, ElementId patch, const Mouth& mouth)
{
    const BSpline2& outline = design.find<Patch>(patch)->outline;
    const double slack = 1e-9 * outline.period();
    const auto within = [&](double t) {
        const double turns = std::floor((t - mouth.from) / outline.period());
        const double at = t - turns * outline.period();
        return at > mouth.from + slack && at < mouth.to - slack;
    };
    bool found = false;
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        if (seam.a.patch != patch || seam.b.patch != patch || found)
            return;
        if (const std::optional<DartShape> dart = dartOf(design, id))
            found = within(dart->from) || within(dart->to);
    });
    return found;
}

Edit addOneDart(const Design& design, const DartShape& shape, Message* problem)
{
    const Patch* patch = design.find<Patch>(shape.patch);
    if (!patch || outlineProblem(patch->outline))
        return refused(problem, {QT_TRANSLATE_NOOP("Message", "There is no such place on an outline."), {}});
    const BSpline2& outline = patch->outline;
    const Mouth mouth = shorterWay(outline, shape.from, shape.to);
    const Vec2 a = outline.at(outline.wrapped(mouth.from)), b = outline.at(outline.wrapped(mouth.to));
    if ((b - a).norm() < narrowest)
        return refused(problem,
                       {QT_TRANSLATE_NOOP("Message", "The mouth of a dart must be at least 1 mm wide."), {}});
    if (hasDartWithin(design, shape.patch, mouth))
        return refused(problem, {QT_TRANSLATE_NOOP("Message", "There is a dart already: put this one beside it, or "
                                                              "remove that one first."),
                                 {}});
    if (!isInside(outline, shape.tip) || std::min((shape.tip - a).norm(), (shape.tip - b).norm()) < shortest)
        return refused(problem, tipProblem());
    std::vector<double> tip;
    const std::optional<BSpline2> cut = withLines(outline, mouth, {shape.tip}, tip);
    if (!cut)
        return refused(problem, legsProblem(design, shape.patch));
    EditBuilder builder(design);
    Patch changed = *patch;
    changed.outline = *cut;
    builder.replace(shape.patch, std::move(changed));

    std::set<ElementId> divided = divideSeams(design, {shape.patch, mouth.from, mouth.to}, builder);
    divided.merge(keepNotches(design, {shape.patch, mouth.from, mouth.to}, builder));
    keepPlaces(design, {mouth.to, mouth.from + outline.period()}, shape.patch, divided, builder);
    closeHeldGap({shape.patch, mouth.from, mouth.to}, builder);
    const double first = cut->wrapped(mouth.from), middle = cut->wrapped(tip.front()),
                 last = cut->wrapped(mouth.to);
    builder.add(
        Seam{{shape.patch, first, middle}, {shape.patch, middle, last}, true, Match::Length, Continuity::C1});
    return builder.result({QT_TRANSLATE_NOOP("Message", "Add a dart to %1"), {displayName(design, shape.patch)}});
}

/// The outlines of twins stay mirror images to the last bit.
Edit withMirroredOutline(const Design& design, const Edit& both, ElementId patch, ElementId twin)
{
    Design now = design.with(both);
    if (!releasedPoints(design, patch).empty())
        return both;
    const std::optional<BSpline2> mirrored = mirroredCurve(now.find<Patch>(patch)->outline);
    Patch changed = *now.find<Patch>(twin);
    const auto same = [](double a, double b) { return std::abs(a - b) < sameSpot; };
    if (!mirrored || !std::ranges::equal(mirrored->knots(), changed.outline.knots(), same))
        return both;
    changed.outline = *mirrored;
    EditBuilder builder(now);
    builder.replace(twin, std::move(changed));
    return editBetween(design, builder.now(), both.verb);
}

/// What was done to a patch, and the same to its twin, if it has one and there it can be done; `same` gets the
/// design as it is by then, and the twin.
Edit alsoForTwin(const Design& design, const Edit& edit, ElementId patch,
                 const std::function<Edit(const Design& now, ElementId twin)>& same)
{
    const ElementId twin = twinOf(design, patch);
    if (edit.empty() || twin == noElement)
        return edit;
    const Design now = design.with(edit);
    const Edit other = same(now, twin);
    if (other.empty())
        return edit;
    return withMirroredOutline(design, editBetween(design, now.with(other), edit.verb), patch, twin);
}

} // namespace

Edit addDart(const Design& design, const DartShape& shape, Message* problem)
{
    return alsoForTwin(
        design, addOneDart(design, shape, problem), shape.patch, [&](const Design& now, ElementId twin) {
            return addOneDart(now, {twin, shape.from, shape.to, mirroredInOutline(shape.tip)}, nullptr);
        });
}

std::optional<DartShape> dartOf(const Design& design, ElementId id)
{
    const Seam* seam = design.find<Seam>(id);
    const std::optional<FoldedSides> legs = seam ? foldedSides(design, *seam) : std::nullopt;
    if (!legs)
        return std::nullopt;
    const BSpline2& outline = design.find<Patch>(legs->patch)->outline;
    const auto at = [&](double t) { return outline.at(outline.wrapped(t)); };
    const auto isStraight = [&](const Stretch& leg) {
        const double end = unwrappedEnd(leg.from, leg.to, outline.domainStart(), outline.domainEnd());
        const double chord = (at(end) - at(leg.from)).norm();
        return ArcLength2(outline).between(leg.from, end) < chord * (1 + 1e-6) + sameSpot;
    };
    if (!isStraight(legs->first) || !isStraight(legs->second))
        return std::nullopt;
    return DartShape{legs->patch, legs->first.from, legs->second.to, legs->tip};
}

ElementId twinDart(const Design& design, const DartShape& dart)
{
    const ElementId twin = twinOf(design, dart.patch);
    ElementId found = noElement;
    if (twin != noElement)
        design.each<Seam>([&](ElementId id, const Seam&) {
            if (const auto other = dartOf(design, id);
                other && other->patch == twin && std::abs(other->from - dart.from) < 1e-9)
                found = id;
        });
    return found;
}

namespace {

Edit removeOneDart(const Design& design, ElementId id, Message* problem)
{
    const std::optional<DartShape> dart = dartOf(design, id);
    if (!dart)
        return refused(problem, {QT_TRANSLATE_NOOP("Message", "Select the seam of a dart."), {}});
    const Patch& patch = *design.find<Patch>(dart->patch);
    const BSpline2& outline = patch.outline;
    const Mouth legs{dart->from, unwrappedEnd(dart->from, dart->to, outline.domainStart(), outline.domainEnd())};
    const std::optional<BSpline2> closed = withoutLegs(outline, legs.from, legs.to, dart->tip);
    if (!closed)
        return refused(problem,
                       {QT_TRANSLATE_NOOP("Message", "Without this dart the outline of %1 would cross itself."),
                        {displayName(design, dart->patch)}});
    EditBuilder builder(design);
    Patch changed = patch;
    changed.outline = *closed;
    builder.replace(dart->patch, std::move(changed));
    builder.remove(id);
    std::set<ElementId> done = joinOverMouth(design, *dart, builder);
    done.insert(id);
    keepPlaces(design, {legs.to, legs.from + outline.period()}, dart->patch, done, builder);
    for (const double corner : {dart->from, dart->to})
        dropStraightCorner(dart->patch, corner, builder);
    return builder.result(
        {QT_TRANSLATE_NOOP("Message", "Remove a dart of %1"), {displayName(design, dart->patch)}});
}

Edit moveOneTip(const Design& design, ElementId id, const Vec2& tip, Message* problem)
{
    const std::optional<DartShape> dart = dartOf(design, id);
    if (!dart)
        return refused(problem, {QT_TRANSLATE_NOOP("Message", "Select the seam of a dart."), {}});
    const Seam& seam = *design.find<Seam>(id);
    const Patch& patch = *design.find<Patch>(dart->patch);
    const BSpline2& outline = patch.outline;
    const auto at = [&](double t) { return outline.at(outline.wrapped(t)); };
    const auto end = [&](double from, double to) {
        return unwrappedEnd(from, to, outline.domainStart(), outline.domainEnd());
    };
    const double middle = end(dart->from, seam.a.from == dart->from ? seam.a.to : seam.b.to);
    const double last = end(middle, dart->to);
    const auto leg = [&](const Vec2& a, const Vec2& b, double span) {
        return polyline({a, b}, outline.degree(), 0, (b - a).norm() / span);
    };
    const Vec2 from = at(dart->from), to = at(dart->to);
    if (std::min((tip - from).norm(), (tip - to).norm()) < shortest)
        return refused(problem, tipProblem());
    // Each leg keeps its parameters, and so does everything on it.
    const BSpline2 whole = joined({outline.part(outline.wrapped(dart->to), outline.wrapped(dart->from)),
                                   leg(from, tip, middle - dart->from), leg(tip, to, last - middle)},
                                  nullptr);
    EditBuilder builder(design);
    Patch changed = patch;
    changed.outline = beginningAt(whole, inFirstTurn(outline, dart->to));
    if (outlineProblem(changed.outline))
        return refused(problem, legsProblem(design, dart->patch));
    const bool begins = changed.outline.domainStart() != outline.domainStart();
    builder.replace(dart->patch, std::move(changed));
    if (begins) // elsewhere than before
        keepPlaces(design, {last, last + outline.period()}, dart->patch, {}, builder);
    return builder.result(
        {QT_TRANSLATE_NOOP("Message", "Move the tip of a dart of %1"), {displayName(design, dart->patch)}});
}

} // namespace

Edit removeDart(const Design& design, ElementId id, Message* problem)
{
    const Edit one = removeOneDart(design, id, problem);
    if (one.empty())
        return one;
    const DartShape dart = *dartOf(design, id);
    const ElementId other = twinDart(design, dart);
    return other == noElement ? one : alsoForTwin(design, one, dart.patch, [&](const Design& now, ElementId) {
        return removeOneDart(now, other, nullptr);
    });
}

Edit moveDartTip(const Design& design, ElementId id, const Vec2& tip, Message* problem)
{
    const Edit one = moveOneTip(design, id, tip, problem);
    if (one.empty())
        return one;
    const DartShape dart = *dartOf(design, id);
    const ElementId other = twinDart(design, dart);
    return other == noElement ? one : alsoForTwin(design, one, dart.patch, [&](const Design& now, ElementId) {
        return moveOneTip(now, other, mirroredInOutline(tip), nullptr);
    });
}

namespace {

/// The same dart with the middle of its mouth elsewhere on the outline without it; `cut` has it.
DartShape shapeAt(const BSpline2& cut, const BSpline2& outline, const DartShape& dart, double at)
{
    const ArcLength2 length(outline);
    const Mouth before{dart.from, unwrappedEnd(dart.from, dart.to, outline.domainStart(), outline.domainEnd())};
    const Vec2 oldFrom = cut.at(cut.wrapped(dart.from)), oldTo = cut.at(cut.wrapped(dart.to));
    const auto isOn = [&](double t, const Vec2& end) {
        return (outline.at(outline.wrapped(t)) - end).norm() < nearlySameSpot;
    };
    // About a mouth that was turned open the outline has given way.
    const bool asItWas = isOn(before.from, oldFrom) && isOn(before.to, oldTo);
    const double half = (asItWas ? length.between(before.from, before.to) : (oldTo - oldFrom).norm()) / 2;
    // The tip lies as before, seen from the mouth.
    const Vec2 along = (oldTo - oldFrom).normalized(), left(-along.y(), along.x());
    const Vec2 seen = dart.tip - (oldFrom + oldTo) / 2;
    const double middle = length.at(outline.wrapped(at));
    const double start = outline.wrapped(length.parameterAt(middle - half)),
                 end = outline.wrapped(length.parameterAt(middle + half));
    const Vec2 from = outline.at(start), to = outline.at(end);
    const Vec2 newAlong = (to - from).normalized(), newLeft(-newAlong.y(), newAlong.x());
    return {dart.patch, start, end, (from + to) / 2 + seen.dot(along) * newAlong + seen.dot(left) * newLeft};
}

} // namespace

Edit moveDart(const Design& design, ElementId id, double at, Message* problem)
{
    const std::optional<DartShape> dart = dartOf(design, id);
    const Edit removed = dart ? removeDart(design, id, problem) : Edit{};
    if (removed.empty())
        return dart ? Edit{} : refused(problem, {QT_TRANSLATE_NOOP("Message", "Select the seam of a dart."), {}});
    const Design without = design.with(removed);
    const auto outlineIn = [&](const Design& in) { return in.find<Patch>(dart->patch)->outline; };
    const DartShape moved = shapeAt(outlineIn(design), outlineIn(without), *dart, at);
    const Edit added = addDart(without, moved, problem);
    if (added.empty())
        return {};
    // It stays the seam that it was, with its trim.
    EditBuilder builder(without.with(added));
    for (const Change& change : added.changes)
        if (const auto now = change.before ? std::nullopt : dartOf(builder.now(), change.id)) {
            const ElementId sameDart = now->patch == dart->patch ? id : twinDart(design, *dart);
            if (sameDart == noElement)
                continue;
            const Seam sewn = *builder.now().find<Seam>(change.id);
            Seam kept = *design.find<Seam>(sameDart);
            kept.a = sewn.a;
            kept.b = sewn.b;
            builder.remove(change.id);
            builder.replace(sameDart, std::move(kept));
        }
    return editBetween(design, builder.now(),
                       {QT_TRANSLATE_NOOP("Message", "Move a dart of %1"), {displayName(design, dart->patch)}});
}

} // namespace bolster::edits
