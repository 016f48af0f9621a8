#include "PictureScene.h"

#include "ColourwayEdits.h"
#include "CoverRefiner.h"
#include "FoamShape.h"
#include "FramePieces.h"
#include "SeamRelief.h"
#include "SeamTrims.h"
#include "StiffFrames.h"

#include <map>
#include <stdexcept>

namespace bolster {

namespace {

Scene sceneOf(const SurfaceMeshPtr& surface, CoverMeshPtr cover)
{
    Scene scene;
    scene.surface = surface;
    scene.cover = std::move(cover);
    scene.checker = false;
    return scene;
}

/// In the fabrics that the patches show.
Scene sceneDressed(const SurfaceMeshPtr& surface, CoverMeshPtr cover, const Design& design, ElementId colourway,
                   const FabricBaker& bake)
{
    Scene scene = sceneOf(surface, std::move(cover));
    scene.patches = patchLooks(design, colourway, bake);
    if (scene.cover) {
        scene.trims = SeamTrims().make(design.with(edits::showColourway(design, colourway)), *scene.cover);
        if (!scene.cover->relief)
            scene.cover = withSeams(scene.cover, design);
    }
    return scene;
}

} // namespace

CoverMeshPtr refinedForPicture(const SurfaceMeshPtr& surface)
{
    try {
        return CoverRefiner().refine(surface, 2);
    } catch (const std::runtime_error&) { // positions that are not finite, or triangles that OpenSubdiv refuses
        return nullptr;
    }
}

CoverMeshPtr withSeams(const CoverMeshPtr& cover, const Design& design)
{
    if (!cover)
        return nullptr;
    auto sewn = std::make_shared<CoverMesh>(*cover);
    sewn->relief = seamRelief(design, *sewn->topology);
    return sewn;
}

std::vector<Scene::FrameLook> framesForPicture(const Design& design, const DesignFiles& files,
                                               const SurfaceMesh* surface)
{
    const FrameSkins pressed(surface), stiff(nullptr);
    std::vector<Scene::FrameLook> frames;
    const auto add = [&](std::shared_ptr<const TriangleMesh> mesh, const Placement& placement,
                         const FrameMaterial& material, const std::string& name) {
        if (mesh)
            frames.push_back(
                {mesh, placement, material, 1, (isStiff(material) ? stiff : pressed).skin(*mesh, placement), name});
    };
    const auto fileOf = [&](ElementId id) {
        const auto found = files.meshes.find(id);
        return found != files.meshes.end() ? found->second : nullptr;
    };
    design.each<Frame>([&](ElementId id, const Frame& frame) {
        add(shownMesh(fileOf(id), frame.hiddenParts), frame, frame.material, frame.name);
    });
    design.each<Foam>([&](ElementId id, const Foam& foam) {
        if (foam.cut)
            return;
        add(foam.shape == Foam::Shape::Mesh ? fileOf(id)
                                            : std::make_shared<const TriangleMesh>(foamMesh(foam.shape, foam.size)),
            foam, {FrameMaterial::Kind::Foam}, foam.name);
    });
    return frames;
}

Scene sceneInFabrics(const SurfaceMeshPtr& surface, CoverMeshPtr cover, const Design& design, ElementId colourway,
                     const FabricBaker& bake)
{
    std::map<ElementId, FabricMapsPtr> baked;
    const FabricBaker once = [&](ElementId id, const Fabric& fabric) {
        if (!baked.contains(id))
            baked.emplace(id, bake ? bake(id, fabric) : nullptr);
        return baked.at(id);
    };
    Scene scene = sceneDressed(surface, std::move(cover), design, colourway, once);
    if (scene.trims)
        for (const TrimMesh::Part& part : scene.trims->parts)
            if (const Fabric* fabric = design.find<Fabric>(part.fabric))
                scene.fabrics[part.fabric] = once(part.fabric, *fabric);
    return scene;
}

Scene sceneWithChecker(const SurfaceMeshPtr& surface, CoverMeshPtr cover, const Design& design, ElementId colourway)
{
    Scene scene = sceneDressed(surface, std::move(cover), design, colourway, {});
    scene.checker = true;
    return scene;
}

Scene sceneWithMap(const SurfaceMeshPtr& surface, CoverMeshPtr cover, const CoverMap& map)
{
    Scene scene = sceneOf(surface, std::move(cover));
    VertexMap shown;
    shown.topology = surface->topology;
    shown.values = map.ofVertex;
    shown.allowed = map.allowed;
    shown.kind = map.scale.kind;
    shown.limit = map.scale.limit;
    scene.map = std::make_shared<const VertexMap>(std::move(shown));
    for (const SurfaceTopology::PatchRange& range : surface->topology->patches)
        scene.patches.push_back({range.patch, "#b9bcc0"}); // where nothing is known
    return scene;
}

} // namespace bolster
