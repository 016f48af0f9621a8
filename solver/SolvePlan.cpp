#include "SolvePlan.h"

#include <algorithm>
#include <iterator>

namespace bolster {

SolvePlan together(SolvePlan a, SolvePlan b)
{
    const auto [less, more] = std::minmax(a, b);
    const bool factorsToo = less == SolvePlan::Refactor && more == SolvePlan::Warp; // which a warp keeps
    return factorsToo ? SolvePlan::Rebuild : more;
}

namespace {

SolvePlan compare(const Settings& a, const Settings& b)
{
    return a.edgeLength == b.edgeLength ? SolvePlan::Nothing : SolvePlan::Rebuild;
}

SolvePlan compare(const Fabric& a, const Fabric& b)
{
    if (a.stiffness != b.stiffness || a.bendingLength != b.bendingLength)
        return SolvePlan::Refactor;
    return a.poisson == b.poisson ? SolvePlan::Nothing : SolvePlan::Retarget;
}

/// `moved`: what it asks for when only points have moved.
template <int Dim>
SolvePlan compareCurves(const BSpline<Dim>& a, const BSpline<Dim>& b, SolvePlan moved)
{
    if (a == b)
        return SolvePlan::Nothing;
    const bool sameKind = a.degree() == b.degree() && a.closed() == b.closed() && a.knots() == b.knots();
    return sameKind ? moved : SolvePlan::Rebuild;
}

SolvePlan compare(const Patch& a, const Patch& b)
{
    // The outward side sits in the order of the triangles, so it needs a new mesh.
    if (a.wrongSideOut != b.wrongSideOut || a.fabric != b.fabric)
        return SolvePlan::Rebuild;
    const SolvePlan outline = compareCurves(a.outline, b.outline, SolvePlan::Warp);
    return std::max(outline, a.pressure == b.pressure ? SolvePlan::Nothing : SolvePlan::Retarget);
}

SolvePlan compare(const FixationCurve& a, const FixationCurve& b)
{
    return compareCurves(a.curve, b.curve, SolvePlan::Retarget);
}

SolvePlan compare(const Orientation& a, const Orientation& b)
{
    if (a.empty() != b.empty())
        return SolvePlan::Rebuild;
    if (a.weight != b.weight)
        return SolvePlan::Refactor;
    return a == b ? SolvePlan::Nothing : SolvePlan::Retarget;
}

SolvePlan compare(const HandleCurve& a, const HandleCurve& b)
{
    if (a.patch != b.patch || a.match != b.match)
        return SolvePlan::Rebuild;
    if (a.hasTarget() != b.hasTarget())
        return SolvePlan::Resew;
    const SolvePlan place =
        a.hasTarget() ? compareCurves(a.target, b.target, SolvePlan::Retarget) : SolvePlan::Nothing;
    return together(compareCurves(a.curve, b.curve, SolvePlan::Warp),
                    together(place, compare(a.orientation, b.orientation)));
}

SolvePlan compare(const FancySeam& a, const FancySeam& b)
{
    if (a.patch != b.patch)
        return SolvePlan::Rebuild;
    if (a.width != b.width || !(a.curve == b.curve))
        return std::max(SolvePlan::Warp, compareCurves(a.curve, b.curve, SolvePlan::Warp));
    return a.depth == b.depth && a.profile == b.profile ? SolvePlan::Nothing : SolvePlan::Republish;
}

SolvePlan compare(const Seam& a, const Seam& b)
{
    if (!(a.a == b.a && a.b == b.b && a.reversed == b.reversed && a.match == b.match))
        return SolvePlan::Resew;
    return a.continuity == b.continuity ? SolvePlan::Nothing : SolvePlan::Refactor;
}

SolvePlan compare(const FixationSeam& a, const FixationSeam& b)
{
    FixationSeam held = b;
    held.orientation = a.orientation;
    held.trim = a.trim;
    return held == a ? compare(a.orientation, b.orientation) : SolvePlan::Resew;
}

/// Of frames and foam: their files are another matter.
SolvePlan compare(const Placement& a, const Placement& b)
{
    return a == b ? SolvePlan::Nothing : SolvePlan::Retarget;
}

SolvePlan compare(const Frame& a, const Frame& b)
{
    if (a.hiddenParts != b.hiddenParts || a.contact != b.contact || (a.contact && a.contactGap != b.contactGap))
        return SolvePlan::Retarget;
    return compare(static_cast<const Placement&>(a), static_cast<const Placement&>(b));
}

/// Weights that differ are noticed when the targets are made anew.
template <class T>
SolvePlan compareButNames(const T& a, const T& b)
{
    T renamed = a;
    renamed.name = b.name;
    return renamed == b ? SolvePlan::Nothing : SolvePlan::Retarget;
}

SolvePlan compare(const Cushion& a, const Cushion& b)
{
    return a.enabled || b.enabled ? compareButNames(a, b) : SolvePlan::Nothing;
}

SolvePlan compare(const Foam& a, const Foam& b)
{
    return compareButNames(a, b);
}

/// A scan that is switched off is measured all the same.
SolvePlan compare(const Scan& a, const Scan& b)
{
    return compareButNames(a, b);
}

SolvePlan compare(const Colourway&, const Colourway&)
{
    return SolvePlan::Nothing;
}

SolvePlan compare(const OutlineTrim&, const OutlineTrim&)
{
    return SolvePlan::Nothing;
}

SolvePlan compare(const Quarantined&, const Quarantined&)
{
    return SolvePlan::Nothing;
}

/// An element that came or went.
SolvePlan planOf(const Element& element)
{
    if (const auto* frame = std::get_if<Frame>(&element))
        return frame->contact ? SolvePlan::Retarget : SolvePlan::Nothing;
    if (std::holds_alternative<Quarantined>(element) || std::holds_alternative<Fabric>(element) ||
        std::holds_alternative<FixationCurve>(element))
        return SolvePlan::Nothing; // fabrics and curves matter through what uses them
    if (std::holds_alternative<Colourway>(element) || std::holds_alternative<OutlineTrim>(element))
        return SolvePlan::Nothing;
    if (patchCurve(element))
        return SolvePlan::Rebuild; // a new handle begins where the surface is, so nothing is torn
    if (std::holds_alternative<Cushion>(element) || std::holds_alternative<Foam>(element) ||
        std::holds_alternative<Scan>(element))
        return SolvePlan::Retarget;
    return SolvePlan::Resew;
}

SolvePlan planOf(const Element& before, const Element& after)
{
    if (before.index() != after.index())
        return SolvePlan::Resew;
    return std::visit([&](const auto& a) { return compare(a, std::get<std::decay_t<decltype(a)>>(after)); },
                      before);
}

/// Whether the place and the file of this element act on the cover or on what is reported of it.
bool acts(const Design& design, ElementId id)
{
    const auto* frame = design.find<Frame>(id);
    bool acts = design.find<Foam>(id) || design.find<Scan>(id) || (frame && frame->contact);
    design.each<Cushion>(
        [&](ElementId, const Cushion& cushion) { acts = acts || (cushion.enabled && cushion.frame == id); });
    return acts;
}

/// What the files of frames, foam and scans ask for: they arrive later than their elements.
template <class Contents>
SolvePlan planFiles(const Contents& a, const Contents& b, const Design& before, const Design& after)
{
    Contents changed;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::inserter(changed, changed.end()));
    const bool used = std::ranges::any_of(
        changed, [&](const auto& file) { return acts(before, file.first) || acts(after, file.first); });
    return used ? SolvePlan::Retarget : SolvePlan::Nothing;
}

} // namespace

SolvePlan planSolve(const SolveInput& before, const SolveInput& after)
{
    SolvePlan plan = std::max(planFiles(before.files.meshes, after.files.meshes, before.design, after.design),
                              planFiles(before.files.clouds, after.files.clouds, before.design, after.design));
    for (ElementId id : differences(before.design, after.design)) {
        const ElementPtr a = before.design.element(id), b = after.design.element(id);
        const bool idle =
            std::holds_alternative<Frame>(a ? *a : *b) && !acts(before.design, id) && !acts(after.design, id);
        if (!idle)
            plan = together(plan, a && b ? planOf(*a, *b) : planOf(a ? *a : *b));
    }
    return plan;
}

} // namespace bolster
