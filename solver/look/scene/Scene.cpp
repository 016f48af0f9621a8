#include "Scene.h"

#include "FabricShown.h"

#include <algorithm>

namespace bolster {

namespace {

constexpr double farthest = 1e8; ///< mm: points beyond are not drawn

bool drawable(const Vec3& p)
{
    return p.allFinite() && p.cwiseAbs().maxCoeff() < farthest;
}

} // namespace

bool Scene::FrameLook::sameFrame(const FrameLook& other) const
{
    return mesh == other.mesh && placement == other.placement && material == other.material &&
           opacity == other.opacity;
}

const Scene::PatchLook* Scene::look(ElementId patch) const
{
    const auto found = std::ranges::find(patches, patch, &PatchLook::patch);
    return found != patches.end() ? &*found : nullptr;
}

Box3 Scene::boundingBox() const
{
    Box3 box;
    const auto extend = [&box](const Vec3& p) {
        if (drawable(p))
            box.extend(p);
    };
    if (surface)
        std::for_each(surface->positions.begin(), surface->positions.end(), extend);
    for (const FrameLook& frame : frames) {
        const std::vector<Vec3> points = placedPoints(frame);
        std::for_each(points.begin(), points.end(), extend);
    }
    return box;
}

std::vector<Scene::PatchLook> patchLooks(const Design& design, ElementId colourway, const FabricBaker& bake)
{
    std::map<ElementId, FabricMapsPtr> baked;
    std::vector<Scene::PatchLook> looks;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        const ElementId shown = fabricShown(design, id, colourway);
        Scene::PatchLook& look = looks.emplace_back(Scene::PatchLook{id});
        const Fabric* fabric = design.find<Fabric>(shown);
        if (!fabric)
            return;
        if (bake && !baked.contains(shown))
            baked.emplace(shown, bake(shown, *fabric));
        look = {id, fabric->color, bake ? baked.at(shown) : nullptr, clothTurn(patch, *fabric)};
    });
    return looks;
}

std::vector<Vec3> placedPoints(const Scene::FrameLook& frame)
{
    std::vector<Vec3> points;
    if (frame.mesh)
        for (const Vec3& p : frame.mesh->points)
            points.push_back(frame.placement.placed(p));
    return points;
}

} // namespace bolster
