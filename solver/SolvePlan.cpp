#include "SolvePlan.h"

#include <algorithm>

namespace bolster {

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

SolvePlan compare(const Patch& a, const Patch& b)
{
    // The outward side sits in the order of the triangles, so it needs a new mesh.
    if (!(a.outline == b.outline) || a.wrongSideOut != b.wrongSideOut || a.fabric != b.fabric)
        return SolvePlan::Rebuild;
    return a.pressure == b.pressure ? SolvePlan::Nothing : SolvePlan::Retarget;
}

SolvePlan compare(const FixationCurve& a, const FixationCurve& b)
{
    if (a.curve == b.curve)
        return SolvePlan::Nothing;
    const bool sameKind = a.curve.degree() == b.curve.degree() && a.curve.closed() == b.curve.closed() &&
                          a.curve.knots() == b.curve.knots();
    return sameKind ? SolvePlan::Retarget : SolvePlan::Rebuild;
}

SolvePlan compare(const Seam& a, const Seam& b)
{
    return a.a == b.a && a.b == b.b && a.reversed == b.reversed && a.match == b.match ? SolvePlan::Nothing
                                                                                      : SolvePlan::Resew;
}

SolvePlan compare(const FixationSeam& a, const FixationSeam& b)
{
    return a == b ? SolvePlan::Nothing : SolvePlan::Resew;
}

SolvePlan compare(const Frame&, const Frame&)
{
    return SolvePlan::Nothing;
}
/// Weights that differ are noticed when the scan's targets are made anew.
SolvePlan compare(const Scan& a, const Scan& b)
{
    Scan renamed = b;
    renamed.name = a.name;
    return a == renamed ? SolvePlan::Nothing : SolvePlan::Retarget;
}
SolvePlan compare(const Quarantined&, const Quarantined&)
{
    return SolvePlan::Nothing;
}

/// An element that came or went.
SolvePlan planOf(const Element& element)
{
    if (std::holds_alternative<Frame>(element) || std::holds_alternative<Quarantined>(element) ||
        std::holds_alternative<Fabric>(element) || std::holds_alternative<FixationCurve>(element))
        return SolvePlan::Nothing; // fabrics and curves matter through what uses them
    if (std::holds_alternative<Scan>(element))
        return SolvePlan::Rebuild;
    return SolvePlan::Resew;
}

SolvePlan planOf(const Element& before, const Element& after)
{
    if (before.index() != after.index())
        return SolvePlan::Resew;
    return std::visit([&](const auto& a) { return compare(a, std::get<std::decay_t<decltype(a)>>(after)); },
                      before);
}

} // namespace

SolvePlan planSolve(const SolveInput& before, const SolveInput& after)
{
    SolvePlan plan = SolvePlan::Nothing;
    for (ElementId id : differences(before.design, after.design)) {
        const ElementPtr a = before.design.element(id), b = after.design.element(id);
        plan = std::max(plan, a && b ? planOf(*a, *b) : planOf(a ? *a : *b));
    }
    if (before.files.clouds != after.files.clouds)
        plan = std::max(plan, SolvePlan::Retarget);
    return plan;
}

} // namespace bolster
