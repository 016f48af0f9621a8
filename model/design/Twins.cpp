#include "Twins.h"

#include <algorithm>

namespace bolster {

namespace {

template <int Dim, class Map>
std::optional<BSpline<Dim>> mapped(const BSpline<Dim>& curve, const Map& map)
{
    if (curve.empty())
        return curve;
    auto points = curve.points();
    for (auto& point : points)
        point = map(point);
    if (BSpline<Dim>::problem(curve.degree(), curve.closed(), points, curve.knots()))
        return std::nullopt;
    return curve.withPoints(std::move(points));
}

template <int Dim, class Map>
int unlike(const BSpline<Dim>& a, const BSpline<Dim>& b, const std::vector<int>& released, int first,
           const Map& map)
{
    if (a.degree() != b.degree() || a.closed() != b.closed() || a.knots() != b.knots())
        return -1;
    int count = 0;
    for (int i = 0; i < a.pointCount(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const bool like = (map(a.points()[at]) - b.points()[at]).norm() <= mirrorTolerance;
        count += !like && !std::binary_search(released.begin(), released.end(), first + i);
    }
    return count;
}

} // namespace

const Twin* twinLink(const Element& element)
{
    return std::visit(
        [](const auto& value) -> const Twin* {
            if constexpr (requires { value.twin; })
                return value.twin ? &*value.twin : nullptr;
            else
                return nullptr;
        },
        element);
}

ElementPtr withTwinLink(const Element& element, std::optional<Twin> link)
{
    return std::visit(
        [&](auto value) {
            if constexpr (requires { value.twin; })
                value.twin = std::move(link);
            return makeElement(std::move(value));
        },
        element);
}

bool canBeTwin(const Element& element)
{
    return std::visit(
        [](const auto& value) {
            return requires
            {
                value.twin;
            };
        },
        element);
}

std::map<ElementId, ElementId> twinPairs(const Design& design)
{
    std::map<ElementId, ElementId> pairs;
    std::set<ElementId> taken;
    for (const auto& [id, element] : design.elements()) {
        const Twin* link = twinLink(*element);
        const ElementPtr original = link && link->of != id ? design.element(link->of) : nullptr;
        const bool holds = original && original->index() == element->index() && !twinLink(*original);
        if (holds && taken.insert(link->of).second)
            pairs.emplace(id, link->of);
    }
    return pairs;
}

ElementId twinOf(const Design& design, ElementId id)
{
    for (const auto& [follower, original] : twinPairs(design))
        if (id == follower || id == original)
            return id == follower ? original : follower;
    return noElement;
}

std::vector<int> releasedPoints(const Design& design, ElementId id)
{
    for (const auto& [follower, original] : twinPairs(design))
        if (id == follower || id == original)
            return twinLink(*design.element(follower))->released;
    return {};
}

Symmetry symmetryOf(const Design& design)
{
    return design.settings().symmetry.value_or(Symmetry());
}

std::optional<BSpline2> mirroredCurve(const BSpline2& curve)
{
    return mapped(curve, mirroredInOutline);
}

std::optional<BSpline3> mirroredCurve(const BSpline3& curve, const Symmetry& symmetry)
{
    return mapped(curve, [&](const Vec3& point) { return symmetry.mirrored(point); });
}

double mirroredGrain(double grain)
{
    return 180 - grain;
}

Orientation mirroredOrientation(Orientation orientation, const Symmetry& symmetry)
{
    for (Vec3& direction : orientation.directions)
        direction = symmetry.mirroredDirection(direction);
    return orientation;
}

int unlikePoints(const Element& original, const Element& follower, const Symmetry& symmetry)
{
    const Twin* link = twinLink(follower);
    const std::vector<int> released = link ? link->released : std::vector<int>();
    const BSpline2* plane = planeCurve(original);
    const BSpline3* space = spaceCurve(original);
    const int flat = plane ? unlike(*plane, *planeCurve(follower), released, 0, mirroredInOutline) : 0;
    const int solid = space ? unlike(*space, *spaceCurve(follower), released, plane ? firstTwinSpacePoint : 0,
                                     [&](const Vec3& point) { return symmetry.mirrored(point); })
                            : 0;
    return flat < 0 || solid < 0 ? -1 : flat + solid;
}

} // namespace bolster
