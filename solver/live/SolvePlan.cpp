#include "SolvePlan.h"

#include "Kinds.h"

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

/// Walks over an element before and after.
class CostWalker {
public:
    SolveCost cost = SolveCost::Nothing;

    template <class Form, class Value>
    void field(const Field& f, const Form&, const Value& a, const Value& b)
    {
        if (!(a == b))
            add(f.cost);
    }
    void field(const Field& f, const Turn&, const Quat& a, const Quat& b)
    {
        if (a.coeffs() != b.coeffs())
            add(f.cost);
    }
    template <int Dim>
    void field(const Field& f, const Curve&, const BSpline<Dim>& a, const BSpline<Dim>& b)
    {
        if (a.empty() != b.empty())
            add(SolveCost::Resew);
        else if (!(a == b))
            add(sameKind(a, b) ? f.cost : SolveCost::Rebuild);
    }
    void field(const Field& f, const Directions&, const Orientation& a, const Orientation& b)
    {
        if (a.empty() != b.empty())
            add(SolveCost::Rebuild);
        else if (a.kind != b.kind || a.directions != b.directions)
            add(f.cost);
    }
    template <class T>
    void group(const Field& f, const T& a, const T& b)
    {
        part(f, a, b);
    }
    template <class T>
    void group(const Field& f, const std::optional<T>& a, const std::optional<T>& b)
    {
        field(f, Flag{}, a, b);
    }
    template <class T>
    void part(const Field& f, const T& a, const T& b)
    {
        if (!(a == b))
            add(f.cost);
        Description<T>::of(*this, a, b);
    }
    template <class Walk>
    void within(const Field&, Walk walk)
    {
        walk(*this);
    }
    template <class T>
    void list(const Field& f, const Entries&, const std::vector<T>& a, const std::vector<T>& b)
    {
        field(f, Flag{}, a, b);
    }
    template <class T>
    void usual(const T&, const T&)
    {}

private:
    void add(SolveCost more) { cost = together(cost, more); }

    /// Only points have moved.
    template <int Dim>
    static bool sameKind(const BSpline<Dim>& a, const BSpline<Dim>& b)
    {
        return a.degree() == b.degree() && a.closed() == b.closed() && a.knots() == b.knots();
    }
};

/// An element that came or went.
SolvePlan planOf(const Element& element)
{
    return std::visit([]<class T>(const T& value) { return Description<T>::comes(value); }, element);
}

SolvePlan planOf(const Element& before, const Element& after)
{
    if (before.index() != after.index())
        return SolvePlan::Resew;
    CostWalker walker;
    std::visit(
        [&]<class T>(const T& a) {
            if constexpr (!requires { Description<T>::shapesNothing; })
                walker.part({}, a, std::get<T>(after));
        },
        before);
    return walker.cost;
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
