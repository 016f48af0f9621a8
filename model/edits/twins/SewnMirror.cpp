#include "SewnMirror.h"

#include "ElementStretches.h"
#include "TwinEdits.h"
#include "Twins.h"

#include <algorithm>
#include <cmath>

namespace bolster::edits {

namespace {

constexpr double ownMirrorTolerance = 1; // mm: of patches and curves that are their own mirror image

/// The stretch where a patch, mirrored at the middle of its box, has this one; nothing when it is another shape.
std::optional<Stretch> stretchInOwnMirror(const Patch& patch, const Stretch& stretch)
{
    const BSpline2& outline = patch.outline;
    const double middle = outline.boundingBox().center().x();
    const double end = unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd());
    const auto mirrored = [&](double t) {
        const Vec2 p = outline.at(outline.wrapped(t));
        return outline.closest({2 * middle - p.x(), p.y()});
    };
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
        if (mirrored(stretch.from + share * (end - stretch.from)).distance > ownMirrorTolerance)
            return std::nullopt;
    const auto tidy = [&](double t) { // mostly a knot
        for (const double knot : outline.breaks())
            if (std::abs(t - knot) < 1e-6 * outline.period())
                return outline.wrapped(knot);
        return t;
    };
    const Stretch result{stretch.patch, tidy(mirrored(end).parameter), tidy(mirrored(stretch.from).parameter)};
    return result.from == stretch.from ? std::nullopt : std::optional(result); // it lies across the middle
}

/// The curve that runs in the mirror as it does itself, only backwards.
bool isOwnMirror(const BSpline3& curve, const Symmetry& symmetry)
{
    if (curve.closed() || curve.empty())
        return false;
    const auto image = mirroredCurve(curve.reversed(), symmetry);
    if (!image)
        return false;
    constexpr int samples = 16;
    for (int i = 0; i <= samples; ++i) {
        const double t = curve.domainStart() + curve.period() * i / samples;
        if ((image->at(t) - curve.at(t)).norm() > ownMirrorTolerance)
            return false;
    }
    return true;
}

} // namespace

SewnMirror::SewnMirror(const Design& design, const Pairs& pairs)
    : m_design(design)
    , m_originals(pairs)
{
    for (const auto& [follower, original] : pairs) {
        m_twins.emplace(follower, original);
        m_twins.emplace(original, follower);
    }
}

ElementId SewnMirror::twin(ElementId id) const
{
    const auto found = m_twins.find(id);
    return found == m_twins.end() ? noElement : found->second;
}

std::optional<SewnMirror::Image> SewnMirror::of(const Stretch& stretch) const
{
    const auto* patch = m_design.find<Patch>(stretch.patch);
    if (!patch || patch->outline.empty())
        return std::nullopt;
    if (const auto* other = m_design.find<Patch>(twin(stretch.patch))) {
        if (other->outline.knots() != patch->outline.knots())
            return std::nullopt;
        return Image{{twin(stretch.patch), stretch.from, stretch.to}, false};
    }
    if (const auto mirrored = stretchInOwnMirror(*patch, stretch))
        return Image{*mirrored, true};
    return std::nullopt;
}

std::optional<Seam> SewnMirror::of(const Seam& seam) const
{
    if (twin(seam.a.patch) == noElement && twin(seam.b.patch) == noElement)
        return std::nullopt;
    Seam result = seam;
    for (Stretch* side : {&result.a, &result.b}) {
        const auto image = of(*side);
        if (!image)
            return std::nullopt;
        *side = image->stretch;
        result.reversed = result.reversed != image->backwards;
    }
    return result;
}

std::optional<FixationSeam> SewnMirror::of(const FixationSeam& fixation) const
{
    const auto stretch = twin(fixation.stretch.patch) == noElement ? std::nullopt : of(fixation.stretch);
    if (!stretch)
        return std::nullopt;
    const Symmetry symmetry = symmetryOf(m_design);
    FixationSeam result = fixation;
    result.stretch = stretch->stretch;
    result.orientation = mirroredOrientation(fixation.orientation, symmetry);
    if (!fixation.hasCurve())
        return result;
    result.curve = twin(fixation.curve);
    if (result.curve != noElement)
        return result;
    const auto* curve = m_design.find<FixationCurve>(fixation.curve);
    if (!curve || !isOwnMirror(curve->curve, symmetry))
        return std::nullopt;
    result.curve = fixation.curve;
    const double both = curve->curve.domainStart() + curve->curve.domainEnd();
    if (result.curveRange)
        result.curveRange = {both - fixation.curveRange->second, both - fixation.curveRange->first};
    result.reversed = !fixation.reversed;
    return result;
}

std::optional<OutlinePlace> SewnMirror::of(const OutlinePlace& place) const
{
    const auto* patch = m_design.find<Patch>(place.patch);
    const auto* other = m_design.find<Patch>(twin(place.patch));
    if (!patch || !other || other->outline.knots() != patch->outline.knots())
        return std::nullopt;
    return OutlinePlace{twin(place.patch), place.at};
}

std::optional<PatchPoint> SewnMirror::of(const PatchPoint& point) const
{
    if (twin(point.patch) == noElement)
        return std::nullopt;
    return PatchPoint{twin(point.patch), mirroredInOutline(point.position)};
}

bool SewnMirror::same(const Stretch& a, const Stretch& b) const
{
    const auto* patch = m_design.find<Patch>(a.patch);
    if (a.patch != b.patch || !patch || patch->outline.empty())
        return false;
    const BSpline2& outline = patch->outline;
    const bool exact = twin(a.patch) != noElement;
    const auto near = [&](double s, double t) {
        if (exact)
            return std::abs(std::remainder(s - t, outline.period())) <= 1e-9 * outline.period();
        return (outline.at(outline.wrapped(s)) - outline.at(outline.wrapped(t))).norm() <= 2 * ownMirrorTolerance;
    };
    return near(a.from, b.from) && near(a.to, b.to);
}

bool SewnMirror::same(const OutlinePlace& a, const OutlinePlace& b) const
{
    const auto* patch = m_design.find<Patch>(a.patch);
    return a.patch == b.patch && patch && !patch->outline.empty() &&
           std::abs(std::remainder(a.at - b.at, patch->outline.period())) <= 1e-9 * patch->outline.period();
}

bool SewnMirror::same(const PatchPoint& a, const PatchPoint& b) const
{
    return a.patch == b.patch && (a.position - b.position).norm() <= mirrorTolerance;
}

SewnMirror::Counterpart SewnMirror::counterpart(const Seam& seam) const
{
    Counterpart result;
    const auto image = of(seam);
    if (!image)
        return result;
    m_design.each<Seam>([&](ElementId id, const Seam& other) {
        if (result.id != noElement)
            return;
        if (same(other.a, image->a) && same(other.b, image->b))
            result = {id, false};
        else if (same(other.a, image->b) && same(other.b, image->a))
            result = {id, true};
    });
    return result;
}

SewnMirror::Counterpart SewnMirror::counterpart(const FixationSeam& fixation) const
{
    Counterpart result;
    const auto image = twin(fixation.stretch.patch) == noElement ? std::nullopt : of(fixation.stretch);
    if (!image)
        return result;
    m_design.each<FixationSeam>([&](ElementId id, const FixationSeam& other) {
        // One that holds the place has nothing to do with one that only holds the orientation.
        if (result.id == noElement && same(other.stretch, image->stretch) &&
            other.hasCurve() == fixation.hasCurve())
            result.id = id;
    });
    return result;
}

bool SewnMirror::released(const Element& sewn) const
{
    bool onTwin = false, released = true;
    const auto look = [&](ElementId id, const auto& pointsOf) {
        const auto* patch = m_design.find<Patch>(id);
        const ElementId other = twin(id);
        if (!patch || patch->outline.empty() || other == noElement)
            return;
        onTwin = true;
        const Twin* link = twinLink(*m_design.element(m_originals.contains(id) ? id : other));
        for (const int point : pointsOf(patch->outline))
            released = released && link && std::ranges::binary_search(link->released, point);
    };
    for (const Stretch& stretch : stretchesOf(sewn))
        look(stretch.patch,
             [&](const BSpline2& outline) { return pointsOnStretch(outline, stretch.from, stretch.to); });
    visitMark(sewn, [&](const auto& mark) {
        if constexpr (requires { mark.place.at; })
            look(mark.place.patch, [&](const BSpline2& outline) {
                return std::vector{outline.pointAt(outline.wrapped(mark.place.at))};
            });
    });
    return onTwin && released;
}

SewnMirror::Pairs heldPairs(const Design& design, const Design& other)
{
    SewnMirror::Pairs pairs = twinPairs(design);
    const SewnMirror::Pairs there = twinPairs(other);
    std::erase_if(pairs, [&](const auto& pair) {
        const auto found = there.find(pair.first);
        return !design.find<FixationCurve>(pair.first) && (found == there.end() || found->second != pair.second);
    });
    return pairs;
}

ElementPtr mirroredDrawn(const Element& drawn, ElementId patch, const Symmetry& symmetry)
{
    const auto curve = mirroredCurve(*planeCurve(drawn));
    if (!curve)
        return nullptr;
    if (const auto* handle = std::get_if<HandleCurve>(&drawn)) {
        HandleCurve copy = *handle;
        const auto target = mirroredCurve(handle->target, symmetry);
        if (!target)
            return nullptr;
        copy.patch = patch;
        copy.curve = *curve;
        copy.target = *target;
        copy.orientation = mirroredOrientation(std::move(copy.orientation), symmetry);
        copy.twin.reset();
        return makeElement(std::move(copy));
    }
    return std::visit(
        [&](auto copy) {
            if constexpr (std::is_base_of_v<PatchCurve, decltype(copy)>) {
                copy.patch = patch;
                copy.curve = *curve;
                copy.twin.reset();
            }
            return makeElement(std::move(copy));
        },
        drawn);
}

} // namespace bolster::edits
