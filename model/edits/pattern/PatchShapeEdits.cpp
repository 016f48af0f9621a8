#include "PatchShapeEdits.h"

#include "EditBuilder.h"
#include "LayoutEdits.h"
#include "PlaneCurves.h"

#include <map>
#include <numbers>

namespace bolster::edits {

namespace {

/// A map of the layout in the outline coordinates of a patch.
Map2 inOutline(const Patch& patch, const Map2& map)
{
    Map2 place = Map2::Identity();
    place.translate(patch.position).rotate(patch.rotation * std::numbers::pi / 180);
    return place.inverse() * map * place;
}

std::optional<BSpline2> checkedMap(const BSpline2& curve, const Map2& map)
{
    std::vector<Vec2> points = curve.points();
    for (Vec2& point : points)
        point = map * point;
    if (BSpline2::problem(curve.degree(), curve.closed(), points, curve.knots()))
        return std::nullopt;
    return curve.withPoints(std::move(points));
}

/// The patches among the ids, and the curves drawn in them, with their patches.
std::map<ElementId, ElementId> withDrawnCurves(const Design& design, std::span<const ElementId> ids)
{
    std::map<ElementId, ElementId> all;
    for (const ElementId id : ids)
        if (design.find<Patch>(id))
            all.emplace(id, id);
    for (const auto& [id, element] : design.elements())
        if (const PatchCurve* drawn = patchCurve(*element); drawn && all.contains(drawn->patch))
            all.emplace(id, drawn->patch);
    return all;
}

bool sensible(const Vec2& factors)
{
    return factors.allFinite() && factors.minCoeff() >= 1e-3 && factors.maxCoeff() <= 1e3;
}

Map2 scaling(const Vec2& centre, const Vec2& factors)
{
    Map2 map = Map2::Identity();
    map.translate(centre).scale(factors).translate(-centre);
    return map;
}

/// Turns round the seams that join a mirrored patch to another one.
void turnSeams(EditBuilder& builder, const std::map<ElementId, ElementId>& mirrored)
{
    const Design before = builder.now();
    before.each<Seam>([&](ElementId id, const Seam& seam) {
        if (mirrored.contains(seam.a.patch) == mirrored.contains(seam.b.patch))
            return;
        Seam turned = seam;
        turned.reversed = !seam.reversed;
        builder.replace(id, turned);
    });
}

} // namespace

Edit scalePatches(const Design& design, std::span<const ElementId> patches, const Vec2& centre, const Vec2& factors)
{
    if (!sensible(factors) || !centre.allFinite() || factors == Vec2(1, 1))
        return {};
    const Map2 map = scaling(centre, factors);
    EditBuilder builder(design);
    for (const auto& [id, patchId] : withDrawnCurves(design, patches)) {
        const Patch& patch = *design.find<Patch>(patchId);
        const Map2 linear(inOutline(patch, map).linear()); // the place takes up the rest
        auto curve = checkedMap(*planeCurve(*design.element(id)), linear);
        if (!curve)
            return {};
        ElementPtr scaled = withPlaneCurve(*design.element(id), std::move(*curve));
        if (id == patchId) {
            Patch placed = std::get<Patch>(*scaled);
            placed.position = map * patch.position;
            scaled = makeElement(std::move(placed));
        }
        builder.set(id, std::move(scaled));
    }
    return builder.result(patchesVerb(design, patches, QT_TRANSLATE_NOOP("Message", "Scale %1"),
                                      QT_TRANSLATE_NOOP("Message", "Scale %1 patches")));
}

Edit resizePatches(const Design& design, std::span<const ElementId> patches, int axis, double size)
{
    Design now = design;
    for (const ElementId id : patches) {
        const Patch* patch = now.find<Patch>(id);
        if (!patch || patch->outline.empty())
            continue;
        const Box2 box = layoutBox(*patch);
        Vec2 factors(1, 1);
        factors[axis] = size / box.sizes()[axis];
        if (!sensible(factors))
            return {};
        const Edit scaled = scalePatches(now, {&id, 1}, box.min(), factors);
        if (scaled.empty() && factors != Vec2(1, 1))
            return {};
        now = now.with(scaled);
    }
    return editBetween(design, now,
                       patchesVerb(design, patches, QT_TRANSLATE_NOOP("Message", "Change the size of %1"),
                                   QT_TRANSLATE_NOOP("Message", "Change the size of %1 patches")));
}

Edit mirrorPatches(const Design& design, std::span<const ElementId> patches, MirrorAxis axis, double at)
{
    if (!std::isfinite(at))
        return {};
    const bool vertical = axis == MirrorAxis::Vertical;
    const int across = vertical ? 0 : 1;
    const std::map<ElementId, ElementId> mirrored = withDrawnCurves(design, patches);
    EditBuilder builder(design);
    for (const auto& [id, patchId] : mirrored) {
        BSpline2 curve = *planeCurve(*design.element(id));
        std::vector<Vec2> points = curve.points();
        for (Vec2& point : points)
            point[across] = -point[across];
        ElementPtr turned = withPlaneCurve(*design.element(id), curve.withPoints(std::move(points)));
        if (id == patchId) {
            Patch patch = std::get<Patch>(*turned);
            patch.position[across] = 2 * at - patch.position[across];
            patch.rotation = patch.rotation == 0 ? 0 : -patch.rotation;
            patch.grain = std::remainder(vertical ? 180 - patch.grain : -patch.grain, 360);
            turned = makeElement(std::move(patch));
        }
        builder.set(id, std::move(turned));
    }
    turnSeams(builder, mirrored);
    return builder.result(patchesVerb(design, patches, QT_TRANSLATE_NOOP("Message", "Mirror %1"),
                                      QT_TRANSLATE_NOOP("Message", "Mirror %1 patches")));
}

} // namespace bolster::edits
